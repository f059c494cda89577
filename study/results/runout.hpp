#pragma once
/// Runout of a block.
#include "core/types.hpp"

namespace clast {

/// Horizontal displacement of a block from its release point: downslope distance and lateral angle.
struct RunoutMeasures {
  double along = 0.0;    ///< distance along the downslope direction, m
  double lateral = 0.0;  ///< lateral angle, rad, positive to the right looking downslope
};
/// Computes the runout of a block.
/// @param downslope  downslope direction, unit vector
RunoutMeasures compute_runout(const Vec3& start, const Vec3& stop, const Vec2& downslope);

}  // namespace clast
