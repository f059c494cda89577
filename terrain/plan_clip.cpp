#include "terrain/plan_clip.hpp"

#include "mesh/plan_geometry.hpp"

namespace clast::terrain_detail {

std::vector<Vec2> clip_to_triangle(std::span<const Vec2> ring, const PlanTriangle& triangle) {
  std::vector<Vec2> kept(ring.begin(), ring.end()), next;
  for (std::size_t k = 0; k < 3 && !kept.empty(); ++k) {
    const Vec2& from = triangle[k];
    const Vec2 along = triangle[(k + 1) % 3] - from;
    next.clear();
    for (std::size_t i = 0; i < kept.size(); ++i) {
      const Vec2 &a = kept[i], &b = kept[(i + 1) % kept.size()];
      const double in_a = cross(along, a - from), in_b = cross(along, b - from);
      if (in_a >= 0.0) next.push_back(a);
      if ((in_a >= 0.0) != (in_b >= 0.0)) next.push_back(a + in_a / (in_a - in_b) * (b - a));
    }
    kept.swap(next);
  }
  return kept;
}

double clipped_area(std::span<const Vec2> ring, const PlanTriangle& triangle) {
  return signed_area(clip_to_triangle(ring, triangle));
}

}  // namespace clast::terrain_detail
