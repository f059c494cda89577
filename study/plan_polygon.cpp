#include "study/plan_polygon.hpp"

#include <cmath>

#include "core/error.hpp"
#include "mesh/triangle_mesh.hpp"

namespace clast {

bool is_inside(std::span<const Vec2> polygon, const Vec2& point) {
  bool odd = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const bool up = a.y() <= point.y() && b.y() > point.y();
    const bool down = b.y() <= point.y() && a.y() > point.y();
    if (!up && !down) continue;
    const Vec2 along = b - a, to_point = point - a;
    const double left = along.x() * to_point.y() - along.y() * to_point.x();
    if (up ? left > 0.0 : left < 0.0) odd = !odd;
  }
  return odd;
}

double polygon_area(std::span<const Vec2> polygon) {
  double twice_area = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 a = polygon[i] - polygon[0];
    const Vec2 b = polygon[(i + 1) % polygon.size()] - polygon[0];
    twice_area += a.x() * b.y() - a.y() * b.x();
  }
  return 0.5 * std::abs(twice_area);
}

void check_has_area(std::span<const Vec2> polygon) {
  Bounds box;
  for (const Vec2& corner : polygon) box.include({corner.x(), corner.y(), 0.0});
  const Vec3 size = box.high - box.low;
  // Random points would hardly ever fall into a polygon thinner than this.
  if (!(polygon_area(polygon) > 1e-3 * size.x() * size.y())) {
    throw InputError(
        "the polygon has no area; give three or more corners that are not on one line");
  }
}

}  // namespace clast
