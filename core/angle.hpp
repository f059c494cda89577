#pragma once
/// Degrees, as files and pages give angles; inside, angles are in radians.
#include "core/types.hpp"

namespace clast {

inline constexpr double kDegreesPerRadian = 180.0 / kPi;
inline constexpr double kRadiansPerDegree = kPi / 180.0;

}  // namespace clast
