#pragma once
/// Rotation of rigid bodies from their angular momentum in world axes, which is constant without
/// torque. Moments are principal; orientations are world_from_body.
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

/// Integrates a short step at constant momentum: second order, time-reversible to third (explicit
/// midpoint on the rotation group).
RotationStep integrate_rotation_step(const Vec3& moments, const Quat& orientation,
                                     const Vec3& momentum, double step);

/// Integrates torque-free rotation by fourth-order Runge-Kutta in steps of at most 0.003 rad,
/// accurate to about 1e-12 rad per radian; for cases without closed form in `FreeRotation`.
Quat integrate_free_rotation(const Vec3& moments, const Quat& orientation, const Vec3& momentum,
                             double duration);

}  // namespace clast::dem_detail
