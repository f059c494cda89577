#pragma once
/// Uncertainty of a surface that was reconstructed from points.
#include <vector>

#include "core/types.hpp"

namespace clast {

/// Bounds of the true surface and volume, due to point spacing and noise.
struct SurfaceUncertainty {
  std::vector<Vec3> inner_points;  ///< points whose hull is inside that of the block, m
  std::vector<Vec3> outer_points;  ///< points whose hull contains the block, m
  double extent_error =
      0.0;  ///< possible error at both ends of each side of the box due to noise, m
  /// Possible decrease and increase of the volume, m^3.
  double volume_below = 0.0, volume_above = 0.0;
};

}  // namespace clast
