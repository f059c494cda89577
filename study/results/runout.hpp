#pragma once
/// How far a block came.
#include "core/types.hpp"

namespace clast {

/// A run's offset from its release point on the map.
struct RunoutDistances {
  double along = 0.0;    ///< m, along downslope
  double lateral = 0.0;  ///< rad, + to the right looking downslope
};
/// @param downslope  unit
RunoutDistances runout(const Vec3& start, const Vec3& stop, const Vec2& downslope);

}  // namespace clast
