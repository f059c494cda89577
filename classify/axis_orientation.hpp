#pragma once
/// Trend and plunge of axes.
#include "core/types.hpp"

namespace clast {

/// Orientation of an axis without direction, such as the long axis of a block.
struct AxisOrientation {
  /// Horizontal direction of the lower end, clockwise from north (+y), rad, in [0, 2 pi). For
  /// horizontal axes, the direction below pi.
  double trend = 0.0;
  double plunge = 0.0;  ///< angle below the horizontal, rad, in [0, pi/2]
};

/// Computes the orientation of an axis in a frame with x east, y north and z up.
/// @param axis  not zero; its length and sign do not affect the result
AxisOrientation axis_orientation(const Vec3& axis);

}  // namespace clast
