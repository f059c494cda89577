#pragma once
/// Principal moments of inertia and the axes that belong to them.
#include "massprops/mass_properties.hpp"

namespace clast {

/// The frame in which the inertia tensor is diagonal.
struct PrincipalFrame {
  Vec3 moments = Vec3::Zero();       ///< kg m^2, ascending
  Quat rotation = Quat::Identity();  ///< source_from_body: columns are the principal axes
  bool has_near_equal_moments = false;         ///< some axes are a convention, not a property of the solid
};

/// Principal moments in ascending order. Each axis points so that its component of largest
/// magnitude is positive (the first such), the last is turned to make the frame right-handed.
///
/// Moments are nearly equal when they differ by less than 1e-6 of the largest, or than the tensor's
/// stated error lets them be distinguished. The axes between them are then set by convention: all
/// three equal, the source's own; two equal, one is the source's x axis as far as it is
/// perpendicular to the third principal axis (y where that is within 26 degrees of x).
/// @throws GeometryError  inertia not positive definite, or breaking the triangle inequality
PrincipalFrame principal_frame(const MassProperties& properties);

}  // namespace clast
