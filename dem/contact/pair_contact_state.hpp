#pragma once
/// Contacts of two bodies, or of a body and the terrain, while they are near each other.
#include <memory>
#include <optional>
#include <type_traits>
#include <variant>

#include "dem/contact/contact_forces.hpp"
#include "dem/search/block_narrow_phase.hpp"
#include "dem/search/rod_narrow_phase.hpp"
#include "dem/search/terrain_narrow_phase.hpp"

namespace clast::dem_detail {

/// Contacts of a pair of bodies over time. The narrow phase runs in the frame of one body, the
/// reference body. It is skipped while the relative displacement is too small to cause contact, and
/// its data are deleted when the bodies are far apart.
class PairContactState {
 public:
  /// Makes the contact state of two bodies.
  /// @param size  smallest side of the smaller body, m
  /// @param model  must outlive the pair, as must the surfaces
  PairContactState(const BlockSurface& reference, const BlockSurface& block, double size,
                   const ContactModel& model);
  PairContactState(const IndexedSurface& terrain, const BlockSurface& block, double size,
                   const ContactModel& model);

  /// Computes the contact loads after a step of `duration`, s. Dissipated energies are added to
  /// `energy_balance()`.
  const ContactLoad& update_loads(const BodyMotion& reference, const BodyMotion& block,
                                  double duration);
  /// Adds a time without contact in which `update_loads` was not called, s.
  void advance_time(double duration) {
    if (near_ && near_->forces.empty()) near_->forces.advance_time(duration);
  }
  /// Ends all contacts, for example when a body is removed. Their energy is added to the energy
  /// balance.
  void end_contacts(const BodyMotion& reference, const BodyMotion& block);

  /// Moves the residual indentations of the pair to `soil` if the bodies have separated or
  /// `is_final` is true. Until then, they do not affect the contacts of other bodies.
  void store_indentations(bool is_final, SoilMemory& soil) {
    if (indentations_ && (is_final || !is_touching()) && !indentations_->empty())
      soil.merge(*indentations_);
  }

  /// Deletes the correction impulse, which must be applied only once. Force and torque stay valid
  /// while neither body moves.
  void clear_correction_impulse() { load_.correction.reset(); }

  /// Returns a relative displacement up to which the bodies cannot touch, m; 0 if unknown.
  double clearance(const BodyMotion& reference, const BodyMotion& block) const;
  /// Returns the effective inverse mass of the block at its contacts, 1/kg
  /// (`ContactForces::contact_mobility`); 0 without contacts.
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
  /// Returns the contact with the largest overlap; empty without contacts.
  std::optional<ContactForces::DeepestContact> deepest_contact() const {
    return near_ ? near_->forces.deepest_contact() : std::nullopt;
  }
  const EnergyBalance& energy_balance() const { return energy_balance_; }

  /// Serialises the state that determines future loads.
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
  /// Narrow phase of the pair: terrain and block, two blocks with faces, or two bodies without
  /// faces.
  using NarrowPhase =
      std::variant<std::unique_ptr<TerrainNarrowPhase>, BlockNarrowPhase, RodNarrowPhase>;
  /// Narrow phase and contact forces of two bodies that are near each other.
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
    Pose pose;  ///< pose of the block in the frame of the reference body, after the last step
    double displacement = 0.0;  ///< bound of the displacement of any block point, m
    /// Value of `displacement` below which contact is impossible, m.
    double separated_until = -1.0;

    template <class Bytes>
    void serialize(Bytes& bytes) {
      visit_narrow_phase([&](auto& kind) { bytes(kind); });
      bytes(forces, pose, displacement, separated_until);
    }
  };

  NarrowPhase make_narrow_phase() const;
  /// Returns the distance between the bounding spheres of the two bodies, m; 0 if unknown.
  double bounding_sphere_distance(const BodyMotion& reference, const BodyMotion& block) const;
  double bounding_box_distance(const Vec3& block_centre) const;
  /// Returns the bound of the accumulated displacement of any block point after a move to `pose`,
  /// m.
  double displacement_to(const Pose& pose) const;
  /// Finds the contact points in world axes, valid until the next call in this thread.
  std::vector<ContactPoint>& find_contact_points(const Pose& world_from_reference,
                                                 const Pose& reference_from_block);

  const IndexedSurface& reference_;
  const BlockSurface* reference_block_ = nullptr;  ///< null for the terrain
  const BlockSurface& block_;
  double size_;
  const ContactModel& model_;
  std::unique_ptr<NarrowPhaseState> near_;
  /// Residual indentations of this pair; null if the ground stores none.
  std::unique_ptr<SoilMemory> indentations_;
  ContactLoad load_;
  EnergyBalance energy_balance_;
};

/// True if the first of two bodies is the reference body of their contacts. It is the body with
/// faces if only one has faces; otherwise, the larger one.
bool is_reference_body(const BlockSurface& first, const BlockSurface& second);

}  // namespace clast::dem_detail
