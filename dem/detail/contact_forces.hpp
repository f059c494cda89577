#pragma once
/// Forces of the contact points of one pair of bodies, with the history that Eqs. 2-5 of the paper
/// ask for. @cite garcia2022
#include <span>
#include <vector>

#include "dem/detail/contact_patches.hpp"
#include "dem/energy_ledger.hpp"

namespace clast {

/// How a body moved over a step: its place at the end, and its mean velocities.
struct BodyMotion {
  Pose world_from_body;                  ///< origin at the centre of mass
  Vec3 velocity = Vec3::Zero();          ///< of the centre, m/s
  Vec3 angular_velocity = Vec3::Zero();  ///< rad/s, world axes

  Vec3 velocity_at(const Vec3& point) const {
    return velocity + angular_velocity.cross(point - world_from_body.translation);
  }
};

/// What the contacts of a pair do to its bodies, in world axes. The other body gets -force.
struct ContactLoad {
  Vec3 force = Vec3::Zero();            ///< on the block
  Vec3 torque = Vec3::Zero();           ///< on the block about its centre of mass
  Vec3 torque_on_other = Vec3::Zero();  ///< on the other body about its own
};

/// The contacts of a block with the ground, or with another block, over time: matched from step to
/// step, loaded by the law, weighted.
class ContactForces {
 public:
  /// @param zones         parameters of each ground zone
  /// @param zone_of_face  of the other surface; empty: all are of zone 0
  /// @param size          smallest side of the block, m
  ContactForces(std::span<const GroundParameters> zones,
                std::span<const std::uint16_t> zone_of_face, const SurfaceFeatures& block,
                double size, const ContactStiffness& stiffness, ContactWeights weights);

  /// Loads at the present contacts after a step of `duration`. Books every joule of the step in
  /// `ledger`.
  /// @param points  in world axes
  /// @param other   the ground does not move
  ContactLoad update(const std::vector<ContactPoint>& points, const BodyMotion& block,
                     const BodyMotion& other, double duration, EnergyLedger& ledger);

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
    Vec3 arm = Vec3::Zero();         ///< from the block's centre of mass, m
    Vec3 other_arm = Vec3::Zero();   ///< from the other body's
  };

  /// Of the two bodies where they touch, the contact's arms as they were when it was loaded.
  static Vec3 relative_velocity(const BodyMotion& block, const BodyMotion& other,
                                const Contact& contact);

  void match(const std::vector<ContactPoint>& points);
  double stored(const Contact& contact) const;

  std::span<const GroundParameters> zones_;
  std::span<const std::uint16_t> zone_of_face_;
  ContactPatches patches_;
  ContactStiffness stiffness_;
  double near_;  ///< contacts closer than this may hand their history on, m
  std::vector<Contact> contacts_;

  // Scratch of one update, kept to spare the allocations.
  std::vector<Contact> now_;
  std::vector<int> previous_of_;  ///< contact of the step before, -1 for none
  std::vector<char> carried_on_;  ///< contacts of the step before that live on
};

}  // namespace clast
