#pragma once
/// The contacts of two bodies, or of a body and the terrain, while they are near each other.
#include <memory>
#include <optional>
#include <type_traits>
#include <variant>

#include "dem/contact/contact_forces.hpp"
#include "dem/search/block_narrow_phase.hpp"
#include "dem/search/rod_narrow_phase.hpp"
#include "dem/search/terrain_narrow_phase.hpp"

namespace clast::dem_detail {

/// The narrow phase runs in the frame of one of the two, the reference body. The pair measures how
/// far they move against each other from the poses themselves, sleeps while that can't bring them
/// together, and keeps what the search needs only while they are near.
class PairContactState {
 public:
  /// @param size   smallest side of the smaller body, m
  /// @param rules  they must outlive the pair
  PairContactState(const BlockSurface& reference, const BlockSurface& block, double size,
                   const ContactModel& model);
  /// A block on the terrain.
  PairContactState(const IndexedSurface& terrain, const BlockSurface& block, double size,
                   const ContactModel& model);

  /// Loads at the present places after a step of `duration`; every joule goes to
  /// `energy_balance()`.
  const ContactLoad& update(const BodyMotion& reference, const BodyMotion& block, double duration);
  /// Lets time pass in which the two do not touch, without an `update`, s.
  void advance_time(double duration) {
    if (near_ && near_->forces.empty()) near_->forces.advance_time(duration);
  }
  /// Ends all contacts, as when a body is removed; what they stored goes to the ledger.
  void end_contacts(const BodyMotion& reference, const BodyMotion& block);

  /// Hands over the dents that the pair made since it last parted, once it has parted or `over`:
  /// until then they are for no contact to find.
  void store_indentations(bool over, SoilMemory& soil) {
    if (indentations_ && (over || !is_touching()) && !indentations_->empty())
      soil.merge(*indentations_);
  }

  /// Forgets the event of the last step, which was applied then: the loads without it hold while
  /// neither of the two moves.
  void clear_event_impulse() { load_.event.reset(); }

  /// How far the two may move against each other from here before they can touch, m; 0 where that
  /// is not known.
  double clearance(const BodyMotion& reference, const BodyMotion& block) const;
  /// Of all contacts together, for the block as `ContactForces::contact_mobility`, and their
  /// weights.
  double contact_mobility(std::span<const double> vertex_mobilities) const {
    return near_ ? near_->forces.contact_mobility(vertex_mobilities) : 0.0;
  }
  double weight() const { return near_ ? near_->forces.weight() : 0.0; }

  const ContactLoad& load() const { return load_; }
  bool is_touching() const { return near_ && !near_->forces.empty(); }
  bool has_narrow_phase() const { return near_ != nullptr; }
  std::size_t contact_count() const { return near_ ? near_->forces.count() : 0; }
  double stored_energy() const { return near_ ? near_->forces.stored_energy() : 0.0; }
  double max_overlap() const { return near_ ? near_->forces.max_overlap() : 0.0; }
  /// The contact with the largest overlap; none without contacts.
  std::optional<ContactForces::DeepestContact> deepest_contact() const {
    return near_ ? near_->forces.deepest_contact() : std::nullopt;
  }
  const EnergyBalance& energy_balance() const { return energy_balance_; }

  /// All that its loads to come depend on.
  template <class Bytes>
  void serialize(Bytes& bytes) {
    bool is_near = has_narrow_phase();
    bytes(is_near);
    if constexpr (Bytes::kReads) {
      if (is_near)
        near_ = std::make_unique<NarrowPhaseState>(make_narrow_phase(), block_, size_, model_);
    }
    if (is_near) bytes(*near_);
    if (indentations_) bytes(*indentations_);
    bytes(load_, energy_balance_);
  }

 private:
  /// The search on the terrain, of which a block has one, is large beside those of its other pairs.
  using NarrowPhase =
      std::variant<std::unique_ptr<TerrainNarrowPhase>, BlockNarrowPhase, RodNarrowPhase>;
  /// What is known while the two are near.
  struct NarrowPhaseState {
    NarrowPhaseState(NarrowPhase of_pair, const BlockSurface& block, double size,
                     const ContactModel& model);
    template <class Use>
    decltype(auto) visit_narrow_phase(const Use& use) {
      return std::visit(
          [&]<class Kind>(Kind& kind) -> decltype(auto) {
            if constexpr (std::is_same_v<Kind, std::unique_ptr<TerrainNarrowPhase>>) {
              return use(*kind);
            } else {
              return use(kind);
            }
          },
          search);
    }
    NarrowPhase search;
    ContactForces forces;
    Pose pose;                      ///< reference_from_block of the last step
    double displacement = 0.0;      ///< no point of the block moved farther since the start, m
    double separated_until = -1.0;  ///< travel before which nothing can touch

    template <class Bytes>
    void serialize(Bytes& bytes) {
      visit_narrow_phase([&](auto& kind) { bytes(kind); });
      bytes(forces, pose, displacement, separated_until);
    }
  };

  NarrowPhase make_narrow_phase() const;
  /// Between their bounding spheres, m; 0 where that is not known.
  double bounding_sphere_distance(const BodyMotion& reference, const BodyMotion& block) const;
  double bounding_box_distance(const Vec3& block_centre) const;
  /// `displacement` of what is near when the block is at `pose`.
  double displacement_to(const Pose& pose) const;
  /// The contact points in world axes, until the next call of any pair in this thread.
  std::vector<ContactPoint>& find_contact_points(const Pose& world_from_reference,
                                                 const Pose& reference_from_block);

  const IndexedSurface& reference_;
  const BlockSurface* reference_block_ = nullptr;  ///< the same, unless it is the terrain
  const BlockSurface& block_;
  double size_;
  const ContactModel& model_;
  std::unique_ptr<NarrowPhaseState> near_;
  std::unique_ptr<SoilMemory> indentations_;  ///< of this touch, where soil remembers
  ContactLoad load_;
  EnergyBalance energy_balance_;
};

/// True when the first of two bodies is the reference body: one with faces before one without, then
/// the larger, then the first.
bool is_reference_body(const BlockSurface& first, const BlockSurface& second);

}  // namespace clast::dem_detail
