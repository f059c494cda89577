#pragma once
/// The contacts of two bodies, or of a body and the terrain, while they are near each other.
#include <memory>
#include <optional>
#include <type_traits>
#include <variant>

#include "dem/contact/contact_forces.hpp"
#include "dem/search/block_contacts.hpp"
#include "dem/search/contact_search.hpp"
#include "dem/search/rod_contacts.hpp"

namespace clast::dem_detail {

/// The narrow phase runs in the frame of one of the two, the reference body. The pair measures how
/// far they move against each other from the poses themselves, sleeps while that can't bring them
/// together, and keeps what the search needs only while they are near.
class BodyPair {
 public:
  /// @param size   smallest side of the smaller body, m
  /// @param rules  they must outlive the pair
  BodyPair(const BlockSurface& reference, const BlockSurface& block, double size,
           const ContactRules& rules);
  /// A block on the terrain.
  BodyPair(const IndexedSurface& terrain, const BlockSurface& block, double size,
           const ContactRules& rules);

  /// Loads at the present places after a step of `duration`; every joule goes to `ledger()`.
  const ContactLoad& update(const BodyMotion& reference, const BodyMotion& block, double duration);
  /// Lets time pass in which the two do not touch, without an `update`, s.
  void wait(double duration) {
    if (near_ && near_->forces.empty()) near_->forces.wait(duration);
  }
  /// Ends all contacts, as when a body is removed; what they stored goes to the ledger.
  void end_contacts(const BodyMotion& reference, const BodyMotion& block);

  /// Hands over the dents that the pair made since it last parted, once it has parted or `over`:
  /// until then they are for no contact to find.
  void remember_dents(bool over, SoilMemory& soil) {
    if (dents_ && (over || !touching()) && !dents_->empty()) soil.take(*dents_);
  }

  /// Forgets the event of the last step, which was applied then: the loads without it hold while
  /// neither of the two moves.
  void drop_event() { load_.event.reset(); }

  /// How far the two may move against each other from here before they can touch, m; 0 where that
  /// is not known.
  double clearance(const BodyMotion& reference, const BodyMotion& block) const;
  /// Of all contacts together, for the block as `ContactForces::mobility`, and their weights.
  double mobility(std::span<const double> of_vertices) const {
    return near_ ? near_->forces.mobility(of_vertices) : 0.0;
  }
  double weight() const { return near_ ? near_->forces.weight() : 0.0; }

  const ContactLoad& load() const { return load_; }
  bool touching() const { return near_ && !near_->forces.empty(); }
  bool near() const { return near_ != nullptr; }
  std::size_t contact_count() const { return near_ ? near_->forces.count() : 0; }
  double stored_energy() const { return near_ ? near_->forces.stored_energy() : 0.0; }
  double max_overlap() const { return near_ ? near_->forces.max_overlap() : 0.0; }
  /// The contact with the largest overlap; none without contacts.
  std::optional<ContactForces::Deepest> deepest() const {
    return near_ ? near_->forces.deepest() : std::nullopt;
  }
  const EnergyLedger& ledger() const { return ledger_; }

  /// All that its loads to come depend on.
  template <class Bytes>
  void serialize(Bytes& bytes) {
    bool is_near = near();
    bytes(is_near);
    if constexpr (Bytes::kReads) {
      if (is_near) near_ = std::make_unique<Near>(new_search(), block_, size_, rules_);
    }
    if (is_near) bytes(*near_);
    if (dents_) bytes(*dents_);
    bytes(load_, ledger_);
  }

 private:
  /// The search on the terrain, of which a block has one, is large beside those of its other pairs.
  using Search = std::variant<std::unique_ptr<ContactSearch>, BlockContacts, RodContacts>;
  /// What is known while the two are near.
  struct Near {
    Near(Search of_pair, const BlockSurface& block, double size, const ContactRules& rules);
    template <class Use>
    decltype(auto) with_search(const Use& use) {
      return std::visit(
          [&]<class Kind>(Kind& kind) -> decltype(auto) {
            if constexpr (std::is_same_v<Kind, std::unique_ptr<ContactSearch>>) {
              return use(*kind);
            } else {
              return use(kind);
            }
          },
          search);
    }
    Search search;
    ContactForces forces;
    Pose pose;                   ///< reference_from_block of the last step
    double travel = 0.0;         ///< no point of the block moved farther since the start, m
    double asleep_until = -1.0;  ///< travel before which nothing can touch

    template <class Bytes>
    void serialize(Bytes& bytes) {
      with_search([&](auto& kind) { bytes(kind); });
      bytes(forces, pose, travel, asleep_until);
    }
  };

  Search new_search() const;
  /// Between their bounding spheres, m; 0 where that is not known.
  double gap_of_spheres(const BodyMotion& reference, const BodyMotion& block) const;
  double gap_of_bounds(const Vec3& block_centre) const;
  /// `travel` of what is near when the block is at `pose`.
  double travel_to(const Pose& pose) const;
  /// The contact points in world axes, until the next call of any pair in this thread.
  std::vector<ContactPoint>& find_points(const Pose& world_from_reference,
                                         const Pose& reference_from_block);

  const IndexedSurface& reference_;
  const BlockSurface* reference_block_ = nullptr;  ///< the same, unless it is the terrain
  const BlockSurface& block_;
  double size_;
  const ContactRules& rules_;
  std::unique_ptr<Near> near_;
  std::unique_ptr<SoilMemory> dents_;  ///< of this touch, where soil remembers
  ContactLoad load_;
  EnergyLedger ledger_;
};

/// True when the first of two bodies is the reference body: one with faces before one without, then
/// the larger, then the first.
bool first_is_reference(const BlockSurface& first, const BlockSurface& second);

}  // namespace clast::dem_detail
