#include "study/results/runout.hpp"

#include <cmath>

namespace clast {

RunoutMeasures compute_runout(const Vec3& start, const Vec3& stop, const Vec2& downslope) {
  const Vec2 offset = (stop - start).head<2>();
  const Vec2 right(downslope.y(), -downslope.x());
  const double along = offset.dot(downslope);
  return {along, std::atan2(offset.dot(right), along)};
}

}  // namespace clast
