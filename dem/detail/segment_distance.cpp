#include "dem/detail/segment_distance.hpp"

#include <algorithm>

namespace clast::dem_detail {
namespace {

/// Squared sine below which two lines count as parallel.
constexpr double kParallel = 1e-12;

}  // namespace

ClosestOnSegments closest_on_segments(const Vec3& a, const Vec3& u, double length_a, const Vec3& b,
                                      const Vec3& v, double length_b) {
  const Vec3 apart = a - b;
  const double cosine = u.dot(v);
  const double sine_squared = 1.0 - cosine * cosine;
  const double along_u = u.dot(apart);
  const double along_v = v.dot(apart);
  ClosestOnSegments closest;
  if (sine_squared > kParallel) {
    closest.first = (cosine * along_v - along_u) / sine_squared;
    closest.second = (along_v - cosine * along_u) / sine_squared;
    closest.crossing = closest.first >= 0.0 && closest.first <= length_a && closest.second >= 0.0 &&
                       closest.second <= length_b;
  }
  if (!closest.crossing) {
    const double s = std::clamp(closest.first, 0.0, length_a);
    closest.second = std::clamp(along_v + s * cosine, 0.0, length_b);
    closest.first = std::clamp(closest.second * cosine - along_u, 0.0, length_a);
  }
  closest.between = apart + closest.first * u - closest.second * v;
  return closest;
}

}  // namespace clast::dem_detail
