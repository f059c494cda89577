#pragma once
/// How far the surface of a block may lie from the one that was found through points.
#include <vector>

#include "core/types.hpp"

namespace clast {

/// What points leave open: they lie a distance apart, and scatter about the surface.
struct SurfaceUncertainty {
  std::vector<Vec3> inner;    ///< their hull lies within that of the block, m
  std::vector<Vec3> outer;    ///< the block lies within their hull, m
  double extent_error = 0.0;  ///< by which noise may have moved each end of each side, m
  /// How much less or more than that of the surface found the volume may be, m^3.
  double volume_below = 0.0, volume_above = 0.0;
};

}  // namespace clast
