#pragma once
/// Mass, centre and inertia tensor of rigid bodies.
#include "core/types.hpp"

namespace clast {

/// Mass properties of a homogeneous solid. `inertia` is about `centre`, with the axes of the frame
/// in which `centre` is given.
struct MassProperties {
  double volume = 0.0;          ///< m^3
  double mass = 0.0;            ///< kg
  Vec3 centre = Vec3::Zero();   ///< m
  Mat3 inertia = Mat3::Zero();  ///< kg m^2, full symmetric matrix
  double relative_error = 0.0;  ///< bound of the relative error of volume and inertia; 0 if exact
};

}  // namespace clast
