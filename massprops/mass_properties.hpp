#pragma once
/// Mass, centre and inertia tensor of rigid bodies.
#include "core/types.hpp"

namespace clast {

/// Of a homogeneous solid. `inertia` is about `centre`, along the axes `centre` is given in.
struct MassProperties {
  double volume = 0.0;          ///< m^3
  double mass = 0.0;            ///< kg
  Vec3 centre = Vec3::Zero();   ///< m
  Mat3 inertia = Mat3::Zero();  ///< kg m^2, full symmetric matrix
  double relative_error = 0.0;  ///< bound on the error of volume and inertia; 0 when exact
};

/// The frame in which the inertia tensor is diagonal.
struct PrincipalFrame {
  Vec3 moments = Vec3::Zero();       ///< kg m^2, ascending
  Quat rotation = Quat::Identity();  ///< source_from_body: columns are the principal axes
  bool nearly_equal = false;         ///< two moments within 1e-6: the axes are a convention
};

/// Principal moments in ascending order. Each axis points so that its component of largest
/// magnitude is positive (the first such), the last is turned to make the frame right-handed.
/// @throws GeometryError  inertia not positive definite, or breaking the triangle inequality
PrincipalFrame principal_frame(const MassProperties& properties);

}  // namespace clast
