#include "mesh/plan_geometry.hpp"

namespace clast {

double signed_area(std::span<const Vec2> polygon) {
  double twice = 0.0;
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
    twice += twice_area(polygon[0], polygon[i], polygon[i + 1]);
  }
  return twice / 2.0;
}

bool is_inside(std::span<const Vec2> polygon, const Vec2& point) {
  bool odd = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const bool up = a.y() <= point.y() && b.y() > point.y();
    const bool down = b.y() <= point.y() && a.y() > point.y();
    if (!up && !down) continue;
    const double left = twice_area(a, b, point);
    if (up ? left > 0.0 : left < 0.0) odd = !odd;
  }
  return odd;
}

}  // namespace clast
