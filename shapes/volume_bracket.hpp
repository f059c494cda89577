#pragma once
/// Bounds of volume and size of incompletely scanned bodies.
#include <optional>
#include <string>

#include "core/types.hpp"

namespace clast {

/// Separate bounds of the sides L, I, S of the smallest box, m.
struct SideBounds {
  Vec3 lower = Vec3::Zero(), upper = Vec3::Zero();
};

/// Bounds of volume and sides of a block, from holes, the unscanned base, gaps between points,
/// noise and duplicate surfaces.
struct VolumeBracket {
  double lower_volume = 0.0;      ///< m^3
  double estimated_volume = 0.0;  ///< m^3, of the closed surface
  /// Upper bound of the volume, m^3; empty if too much of the surface is unscanned.
  std::optional<double> upper_volume = {};
  std::optional<SideBounds> sides = {};  ///< empty if nothing is known of the sides
  double filled_fraction = 0.0;          ///< filled fraction of the closed surface's area
  std::string assumption = {};  ///< behind the bounds, as a sentence; empty if there is none
};

/// Converts the bracket to another length unit.
/// @param unit  new units per old unit
VolumeBracket scaled(VolumeBracket bracket, double unit);

}  // namespace clast
