#pragma once
/// Runout of a block.
#include "core/types.hpp"

namespace clast {

/// Displacement of a run from its release point, in plan.
struct RunoutDistances {
  double along = 0.0;    ///< along the downslope direction, m
  double lateral = 0.0;  ///< rad, positive to the right looking downslope
};
/// Computes the runout.
/// @param downslope  unit vector
RunoutDistances runout(const Vec3& start, const Vec3& stop, const Vec2& downslope);

}  // namespace clast
