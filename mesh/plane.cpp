#include "mesh/plane.hpp"

namespace clast {

std::vector<Vec3> clip_polygon_below(const std::vector<Vec3>& polygon, const Plane& plane) {
  std::vector<Vec3> kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec3 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const double height_a = plane.signed_distance(a), height_b = plane.signed_distance(b);
    if (height_a <= 0.0) kept.push_back(a);
    if (height_a * height_b < 0.0) kept.push_back(a + height_a / (height_a - height_b) * (b - a));
  }
  return kept;
}

}  // namespace clast
