#pragma once
/// Rotation of a rigid body from its angular momentum in world axes, which is what stays constant
/// without torque. Moments are principal; orientations are world_from_body.
#include "core/types.hpp"

namespace clast::dem_detail {

Vec3 angular_momentum(const Vec3& moments, const Quat& orientation, const Vec3& angular_velocity);
Vec3 angular_velocity(const Vec3& moments, const Quat& orientation, const Vec3& momentum);

/// The turn by a rotation vector, rad.
Quat rotation_from_vector(const Vec3& rotation);

struct RotationStep {
  Quat orientation;       ///< world_from_body at the end
  Vec3 angular_velocity;  ///< mean of both ends, rad/s, world axes
};

/// One short step at constant momentum, second order and reversible to third (explicit midpoint on
/// the rotation group).
RotationStep integrate_rotation_step(const Vec3& moments, const Quat& orientation, const Vec3& momentum,
                         double step);

/// A torque-free turn by fourth-order Runge-Kutta in steps of at most 0.003 rad, good to about
/// 1e-12 rad per radian: where `FreeRotation` has no closed form.
Quat integrate_free_rotation(const Vec3& moments, const Quat& orientation, const Vec3& momentum,
                   double duration);

}  // namespace clast::dem_detail
