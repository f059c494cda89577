#pragma once
/// Rotation of rigid bodies from their angular momentum in world axes, which is constant without
/// torque. `moments` are principal moments of inertia; orientations are world_from_body.
#include "core/types.hpp"

namespace clast::dem_detail {

/// Returns a rotated vector, with the bits of Eigen's product. The components are written out: a
/// load of two components together would wait for both to be stored one by one.
inline Vec3 rotated(const Quat& rotation, const Vec3& vector) {
  const double w = rotation.w(), x = rotation.x(), y = rotation.y(), z = rotation.z();
  const double a = vector.x(), b = vector.y(), c = vector.z();
  const double p = 2.0 * (y * c - z * b), q = 2.0 * (z * a - x * c), r = 2.0 * (x * b - y * a);
  return {a + w * p + (y * r - z * q), b + w * q + (z * p - x * r), c + w * r + (x * q - y * p)};
}

Vec3 angular_momentum(const Vec3& moments, const Quat& orientation, const Vec3& angular_velocity);
Vec3 angular_velocity(const Vec3& moments, const Quat& orientation, const Vec3& momentum);

/// Converts a rotation vector, rad, to a quaternion.
Quat rotation_from_vector(const Vec3& rotation);

struct RotationStep {
  Quat orientation;  ///< orientation at the end of the step, world_from_body
  /// Mean of the angular velocities at both ends of the step, rad/s, world axes.
  Vec3 angular_velocity;
};

/// Integrates the rotation over a short step at constant angular momentum by the explicit midpoint
/// rule, which has second-order accuracy.
RotationStep integrate_rotation_step(const Vec3& moments, const Quat& orientation,
                                     const Vec3& momentum, double step);

/// Integrates torque-free rotation by fourth-order Runge-Kutta in steps of at most 0.003 rad. The
/// error is about 1e-12 rad per radian. `FreeRotation` uses it if its closed form is inaccurate.
Quat integrate_free_rotation(const Vec3& moments, const Quat& orientation, const Vec3& momentum,
                             double duration);

}  // namespace clast::dem_detail
