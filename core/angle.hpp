#pragma once
/// Conversion between radians, used internally, and degrees, used in files and on pages.
#include "core/types.hpp"

namespace clast {

inline constexpr double kDegreesPerRadian = 180.0 / kPi;
inline constexpr double kRadiansPerDegree = kPi / 180.0;

}  // namespace clast
