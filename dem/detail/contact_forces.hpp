#pragma once
/// Forces of the contact points, with the history that Eqs. 2-5 of the paper ask for.
/// @cite garcia2022
#include <array>
#include <span>
#include <vector>

#include "dem/detail/contact_search.hpp"
#include "dem/release.hpp"

namespace clast {

/// Force and torque about the centre of mass, in world axes.
struct ContactLoad {
  Vec3 force = Vec3::Zero();
  Vec3 torque = Vec3::Zero();
};

/// One block's contacts over time: matched from step to step, loaded by the law, weighted.
class ContactForces {
 public:
  ContactForces(const TerrainSurface& terrain, std::span<const GroundParameters> zones,
                const SurfaceFeatures& block, const RigidBody& body,
                const ReleaseSettings& settings);

  /// Loads at the present contacts after a step of `duration`, during which the block moved with
  /// the mean velocities given. Books every joule of the step in `ledger`.
  ContactLoad update(const std::vector<ContactPoint>& points, const Pose& world_from_body,
                     const Vec3& velocity, const Vec3& angular_velocity, double duration,
                     EnergyLedger& ledger);

  bool empty() const { return contacts_.empty(); }
  double stored_energy() const;  ///< what unloading would give back, J
  double max_overlap() const;    ///< m
  /// Deepest of the laws that carry the block, vertically, m: a wedge between steep walls is tight
  /// but not deep.
  double settled_depth();
  /// Smallest e_n^2 among the present contacts; 1 without any.
  double smallest_restitution() const;

 private:
  /// A contact point with its loads before weighting.
  struct Contact {
    ContactPoint point;
    const GroundParameters* ground = nullptr;
    double weight = 1.0;
    double normal = 0.0;             ///< N
    Vec3 tangential = Vec3::Zero();  ///< N
    Vec3 rolling = Vec3::Zero();     ///< N m
  };

  void match(const std::vector<ContactPoint>& points);
  void share_weights(std::vector<Contact>& contacts, const Quat& orientation);
  void join_patches(const std::vector<Contact>& contacts, const Quat& orientation);
  std::size_t patch_of(std::size_t contact);
  /// Planes and straight edges of the block that a contact point lies on.
  std::span<const std::uint32_t> joints_of(const ContactPoint& point,
                                           std::array<std::uint32_t, 3>& buffer) const;
  double stored(const Contact& contact) const;

  const TerrainSurface& terrain_;
  std::span<const GroundParameters> zones_;
  const SurfaceFeatures& block_;
  ContactStiffness stiffness_;
  ContactWeights weights_;
  double near_;  ///< contacts closer than this may hand their history on, m
  std::vector<Contact> contacts_;

  // Scratch of one update, kept to spare the allocations.
  std::vector<Contact> now_;
  std::vector<int> previous_of_;    ///< contact of the step before, -1 for none
  std::vector<char> carried_on_;    ///< contacts of the step before that live on
  std::vector<std::size_t> patch_;  ///< union-find over the contacts
  std::vector<double> patch_overlap_;
  std::vector<std::vector<std::uint32_t>> on_joint_;  ///< contacts on each plane and line
  std::vector<std::uint32_t> joints_used_;
};

}  // namespace clast
