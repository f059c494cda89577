#pragma once
/// Rotation of rigid bodies from their angular momentum in world axes, which is constant without
/// torque. `moments` are principal moments of inertia; orientations are world_from_body.
#include "core/types.hpp"

namespace clast::dem_detail {

Vec3 angular_momentum(const Vec3& moments, const Quat& orientation, const Vec3& angular_velocity);
Vec3 angular_velocity(const Vec3& moments, const Quat& orientation, const Vec3& momentum);

/// Returns the rotation by a rotation vector, rad.
Quat rotation_from_vector(const Vec3& rotation);

struct RotationStep {
  Quat orientation;       ///< world_from_body at the end
  Vec3 angular_velocity;  ///< mean of both ends, rad/s, world axes
};

/// Integrates a short step at constant momentum by the explicit midpoint rule on the rotation
/// group. It is of second order and time-reversible to third order.
RotationStep integrate_rotation_step(const Vec3& moments, const Quat& orientation,
                                     const Vec3& momentum, double step);

/// Integrates torque-free rotation by fourth-order Runge-Kutta in steps of at most 0.003 rad. The
/// error is about 1e-12 rad per radian. `FreeRotation` uses it if its closed form is inaccurate.
Quat integrate_free_rotation(const Vec3& moments, const Quat& orientation, const Vec3& momentum,
                             double duration);

}  // namespace clast::dem_detail
