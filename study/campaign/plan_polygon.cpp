#include "study/campaign/plan_polygon.hpp"

#include <cmath>

#include "core/error.hpp"
#include "mesh/triangle_mesh.hpp"

namespace clast {

namespace {

/// Sine of an angle that counts as none.
constexpr double kStraight = 1e-9;

double signed_double_area(std::span<const Vec2> polygon) {
  double twice_area = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    twice_area += cross(polygon[i] - polygon[0], polygon[(i + 1) % polygon.size()] - polygon[0]);
  }
  return twice_area;
}

/// Does the way turn to the right there, seen along `way`?
bool turns_right(const Vec2& way, const Vec2& next) {
  return cross(way, next) < -kStraight * way.norm() * next.norm();
}

}  // namespace

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
  return 0.5 * std::abs(signed_double_area(polygon));
}

std::optional<std::size_t> reflex_corner(std::span<const Vec2> polygon) {
  const double sense = signed_double_area(polygon) < 0.0 ? -1.0 : 1.0;
  const std::size_t corners = polygon.size();
  const auto way = [&](std::size_t from, std::size_t to) {
    const Vec2 straight = polygon[to % corners] - polygon[from % corners];
    return Vec2(straight.x(), sense * straight.y());
  };
  for (std::size_t i = 0; i < corners; ++i) {
    if (turns_right(way(i, i + 1), way(i + 1, i + 2))) return (i + 1) % corners;
  }
  // A star turns more than once, always to the same side.
  for (std::size_t i = 0; i < corners; ++i) {
    for (std::size_t step = 2; step < corners; ++step) {
      if (turns_right(way(i, i + 1), way(i, i + step))) return (i + 1) % corners;
    }
  }
  return std::nullopt;
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
