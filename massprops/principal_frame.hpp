#pragma once
/// Principal moments and axes of inertia.
#include "massprops/mass_properties.hpp"

namespace clast {

/// Frame in which the inertia tensor is diagonal.
struct PrincipalFrame {
  Vec3 moments = Vec3::Zero();          ///< kg m^2, ascending
  Quat rotation = Quat::Identity();     ///< source_from_body; its columns are the principal axes
  bool has_near_equal_moments = false;  ///< true if two or three axes are set by convention
};

/// Computes the principal moments, ascending, and their axes. The component of largest magnitude of
/// the first two axes is positive. The third axis makes the frame right-handed.
///
/// Moments are nearly equal if they differ by less than 1e-6 of the largest or by less than the
/// stated error of the tensor. Their axes are then set by convention. If all three are equal, they
/// are the source axes. If two are equal, one is the source x axis projected perpendicular to the
/// third principal axis (the y axis if that is within 26 degrees of x).
/// @throws GeometryError  if the tensor is not positive definite or violates the triangle
///                        inequality
PrincipalFrame principal_frame(const MassProperties& properties);

}  // namespace clast
