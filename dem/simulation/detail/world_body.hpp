#pragma once
/// Bodies of a simulation, with shared shapes.
#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "dem/contact/stiffness.hpp"
#include "dem/motion/rigid_body_integrator.hpp"
#include "dem/motion/sleep_detector.hpp"
#include "dem/surface/block_surface.hpp"

namespace clast::dem_detail {

/// Shape of bodies, with precomputed contact data. Several bodies share one shape.
struct BodyShape {
  explicit BodyShape(RigidBody of_body)
      : body(std::move(of_body)),
        surface(body.shape),
        radius(body.bounding_radius()),
        mobilities(vertex_mobilities(body)),
        largest_mobility(*std::max_element(mobilities.begin(), mobilities.end())) {}
  RigidBody body;
  BlockSurface surface;
  double radius;                   ///< radius of the rounded body about its centre of mass, m
  std::vector<double> mobilities;  ///< inverse effective mass at each vertex, 1/kg
  double largest_mobility;
};

/// Range of the indices of the bodies that a confining wall holds.
struct ConfinedBodyRange {
  std::size_t first = 0, end = 0;

  bool contains(std::size_t body) const { return body >= first && body < end; }
  template <class Bytes>
  void serialize(Bytes& bytes) {
    bytes(first, end);
  }
};

struct WorldBody {
  /// Makes a body.
  /// @param of_shape  must outlive the body
  WorldBody(const BodyShape& of_shape, const RigidState& start, bool is_fixed)
      : shape(&of_shape),
        integrator(of_shape.body, start),
        fixed(is_fixed),
        motion(integrator.current_motion()) {
    if (fixed) motion = motion_at_rest();
  }
  BodyMotion motion_at_rest() const {
    BodyMotion still;
    still.world_from_body = integrator.state().world_from_body();
    return still;
  }
  bool is_immobile() const { return fixed || inactive; }
  void apply_motion(const BodyMotion& over_step) {
    const Pose &from = motion.world_from_body, &to = over_step.world_from_body;
    path_length += (to.translation - from.translation).norm();
    rotation_path += 2.0 * (from.rotation.conjugate() * to.rotation).vec().norm();
    motion = over_step;
  }
  /// True if the body does not move in the next step: it is fixed, inactive or asleep.
  bool is_idle() const { return is_immobile() || asleep; }
  /// Returns the kinetic plus potential energy, J.
  double energy(double gravity) const {
    return integrator.kinetic_energy() +
           shape->body.mass * gravity * integrator.state().position.z();
  }
  /// Serialises the state of the body without its shape.
  template <class Bytes>
  void serialize(Bytes& bytes) {
    bytes(integrator, fixed, confined, inactive, off_terrain, motion, path_length, rotation_path,
          force, torque, touching, correction_energy, resting_time, asleep, sleep_detector,
          pair_steps);
  }

  const BodyShape* shape;
  RigidBodyIntegrator integrator;
  bool fixed;
  /// Bodies that it holds, if the body is a confining wall.
  std::optional<ConfinedBodyRange> confined;
  bool inactive = false;       ///< true if it left the terrain or was removed
  bool off_terrain = false;    ///< true if it left the terrain in the last step
  BodyMotion motion;           ///< motion over the last step
  double path_length = 0.0;    ///< sum of the displacements of its centre in all steps, m
  double rotation_path = 0.0;  ///< sum of 2 sin(angle/2) over all steps, with their rotation angles
  Vec3 force = Vec3::Zero();
  Vec3 torque = Vec3::Zero();
  bool touching = false;           ///< true if it has contacts
  double correction_energy = 0.0;  ///< energy added by the correction impulses of the last step, J
  double resting_time = 0.0;       ///< time for which it has been slow and in contact, s
  bool asleep = false;             ///< true if it and all bodies that it touches are at rest
  SleepDetector sleep_detector;    ///< active while the body is slow enough to rest
  /// Number of touching pairs of which this body is not the reference body, summed over all steps.
  std::uint64_t pair_steps = 0;
};

}  // namespace clast::dem_detail
