#pragma once
/// How large and how small a body may be whose surface was not scanned completely.
#include <optional>
#include <string>

#include "core/types.hpp"

namespace clast {

/// Bounds of the sides of the smallest box, each by itself: L, I, S in m.
struct SideBounds {
  Vec3 lower = Vec3::Zero(), upper = Vec3::Zero();
};

/// Bounds of volume and sides: what holes, the unscanned base, gaps between points, noise and
/// copies of the surface leave open of a block.
struct VolumeBracket {
  double lower_volume = 0.0;  ///< m^3
  double estimated_volume = 0.0;   ///< m^3, of the closed surface
  /// m^3; none if too large a part of the surface was not scanned to bound the block from above.
  std::optional<double> upper_volume = {};
  std::optional<SideBounds> sides = {};  ///< none: nothing is known of the sides
  double filled_fraction = 0.0;           ///< filled part of the closed surface's area
  std::string assumption = {};           ///< behind the bounds, in words; empty: they have none
};

/// The bracket in another unit of length.
/// @param unit  new units per old one
VolumeBracket scaled(VolumeBracket bracket, double unit);

}  // namespace clast
