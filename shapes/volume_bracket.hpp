#pragma once
/// Bounds of volume and size of incompletely scanned bodies.
#include <optional>
#include <string>

#include "core/types.hpp"

namespace clast {

/// Lower and upper bounds of the sides L, I, S of the smallest box, m.
struct BoxSideBounds {
  Vec3 lower = Vec3::Zero(), upper = Vec3::Zero();
};

/// Two-sided intervals that hold the true values with a probability of 90 %, m and m^3.
struct SizeIntervals {
  double lower_volume = 0.0, upper_volume = 0.0;
  BoxSideBounds sides;
};

/// Bounds of the volume and box sides of a block. They allow for holes, an unscanned base, gaps
/// between points, noise and duplicate surfaces.
struct VolumeBracket {
  double lower_volume = 0.0;      ///< m^3
  double estimated_volume = 0.0;  ///< volume of the closed surface, m^3
  /// Upper bound of the volume, m^3; empty if too much of the surface is unscanned.
  std::optional<double> upper_volume = {};
  std::optional<BoxSideBounds> sides = {};      ///< empty if the sides are unknown
  std::optional<SizeIntervals> intervals = {};  ///< empty if no probabilities are known
  double filled_fraction = 0.0;  ///< area of filled holes over area of the closed surface
  std::string assumption = {};  ///< assumption of the bounds, as a sentence; empty if there is none
};

/// Converts a volume bracket to another length unit.
/// @param unit  new units per old unit
VolumeBracket scaled(VolumeBracket bracket, double unit);

}  // namespace clast
