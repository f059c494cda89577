#pragma once
/// Motion of bodies over a time step, absolute and relative.
#include "core/pose.hpp"

namespace clast::dem_detail {

/// Returns the velocity of a point of a rigid body. The components are written out: a load of two
/// components together would wait for both to be stored one by one.
/// @param centre  point of the body with the velocity `velocity`
inline Vec3 velocity_of_point(const Vec3& velocity, const Vec3& angular_velocity,
                              const Vec3& centre, const Vec3& point) {
  const double x = point.x() - centre.x(), y = point.y() - centre.y(), z = point.z() - centre.z();
  const Vec3& w = angular_velocity;
  return {velocity.x() + (w.y() * z - w.z() * y), velocity.y() + (w.z() * x - w.x() * z),
          velocity.z() + (w.x() * y - w.y() * x)};
}
/// Returns the scalar product of two vectors, component by component, for the same reason.
inline double scalar_product(const Vec3& a, const Vec3& b) {
  return a.x() * b.x() + a.y() * b.y() + a.z() * b.z();
}

/// Motion of a body over a time step: final pose, mean velocities, and initial position and
/// velocities. By default, the body is at rest.
struct BodyMotion {
  Pose world_from_body;  ///< final pose, with the centre of mass as origin of the body frame
  Vec3 velocity = Vec3::Zero();          ///< mean velocity of the centre of mass, m/s
  Vec3 angular_velocity = Vec3::Zero();  ///< mean angular velocity, rad/s, world axes

  Vec3 begin_position = Vec3::Zero();  ///< position of the centre of mass at the start of the step
  Vec3 begin_velocity = Vec3::Zero();
  Vec3 begin_angular_velocity = Vec3::Zero();

  double inverse_mass = 0.0;  ///< 1/kg; 0 for a fixed body
  /// Inverse principal moments of inertia, along the body axes, 1/(kg m^2).
  Vec3 inverse_moments = Vec3::Zero();

  Vec3 velocity_at(const Vec3& point) const {
    return velocity_of_point(velocity, angular_velocity, world_from_body.translation, point);
  }
  /// Returns the mean velocity of the material point that was at `point` at the start of the step.
  Vec3 velocity_of_start_point(const Vec3& point) const {
    return velocity_of_point(velocity, angular_velocity, begin_position, point);
  }
  Vec3 start_velocity_at(const Vec3& point) const {
    return velocity_of_point(begin_velocity, begin_angular_velocity, begin_position, point);
  }
  /// True if the body moved during the step; false for the ground.
  bool is_moving() const {
    return !(velocity.isZero(0.0) && angular_velocity.isZero(0.0) && begin_velocity.isZero(0.0) &&
             begin_angular_velocity.isZero(0.0));
  }
  template <class Bytes>
  void serialize(Bytes& bytes) {
    bytes(world_from_body, velocity, angular_velocity, begin_position, begin_velocity,
          begin_angular_velocity, inverse_mass, inverse_moments);
  }
  /// Multiplies a torque by the inverse inertia tensor, in world axes.
  Vec3 apply_inverse_inertia(const Vec3& torque) const {
    const Vec3 in_body = world_from_body.rotation.conjugate() * torque;
    return world_from_body.rotation * Vec3(inverse_moments.cwiseProduct(in_body));
  }
};

/// Relative motion of a block and the other body of its pair over a step.
struct RelativeMotion {
  RelativeMotion(const BodyMotion& of_block, const BodyMotion& of_other, double step)
      : block(of_block),
        other(of_other),
        duration(step),
        spin(of_block.angular_velocity - of_other.angular_velocity),
        other_is_moving(of_other.is_moving()) {}

  /// Returns the mean relative velocity of the material points that are at `position` at the end of
  /// the step.
  Vec3 velocity_at(const Vec3& position) const {
    return other_is_moving ? Vec3(block.velocity_at(position) - other.velocity_at(position))
                           : block.velocity_at(position);
  }
  /// Returns the mean relative velocity of the material points that were at `position` at the start
  /// of the step.
  Vec3 velocity_of_start_point(const Vec3& position) const {
    return other_is_moving ? Vec3(block.velocity_of_start_point(position) -
                                  other.velocity_of_start_point(position))
                           : block.velocity_of_start_point(position);
  }
  Vec3 start_velocity_at(const Vec3& position) const {
    return other_is_moving
               ? Vec3(block.start_velocity_at(position) - other.start_velocity_at(position))
               : block.start_velocity_at(position);
  }

  const BodyMotion& block;
  const BodyMotion& other;
  double duration;  ///< s
  Vec3 spin;        ///< mean relative angular velocity, rad/s
  bool other_is_moving;
};

}  // namespace clast::dem_detail
