#include "study/campaign/plan_polygon.hpp"

#include <cmath>

#include "core/error.hpp"
#include "mesh/plan_geometry.hpp"
#include "mesh/triangle_mesh.hpp"

namespace clast {

namespace {

/// Sine of an angle that counts as none.
constexpr double kStraight = 1e-9;

/// True if the path turns right from `way` to `next`.
bool turns_right(const Vec2& way, const Vec2& next) {
  return cross(way, next) < -kStraight * way.norm() * next.norm();
}

}  // namespace

std::optional<std::size_t> find_reflex_vertex(std::span<const Vec2> polygon) {
  const double sense = signed_area(polygon) < 0.0 ? -1.0 : 1.0;
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
  if (!(std::abs(signed_area(polygon)) > 1e-3 * size.x() * size.y())) {
    throw InputError(
        "the polygon has no area; give three or more corners that are not on one line");
  }
}

}  // namespace clast
