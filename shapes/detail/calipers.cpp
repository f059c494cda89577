#include "shapes/detail/calipers.hpp"

#include <algorithm>
#include <cmath>

#include "shapes/convex_outline.hpp"

namespace clast {
namespace {

/// Extents that calipers and all points together give may differ by this share through rounding.
constexpr double kRounding = 1e-12;

/// The rectangle around all points with a side along `direction`.
EnclosingRectangle rectangle_along(std::span<const Vec2> points, const Vec2& direction,
                                   double radius) {
  const Vec2 inward(-direction.y(), direction.x());
  Vec2 low = Vec2::Constant(1e300), high = -low;
  for (const Vec2& point : points) {
    const Vec2 turned(direction.dot(point), inward.dot(point));
    low = low.cwiseMin(turned);
    high = high.cwiseMax(turned);
  }
  EnclosingRectangle rectangle;
  rectangle.direction = direction;
  rectangle.length_along = high.x() - low.x() + 2.0 * radius;
  rectangle.length_across = high.y() - low.y() + 2.0 * radius;
  return rectangle;
}

}  // namespace

EnclosingRectangle smallest_rectangle(std::vector<Vec2> points, double radius) {
  return smallest_outline_rectangle(convex_hull_2d(std::move(points)), radius);
}

EnclosingRectangle smallest_outline_rectangle(std::span<const Vec2> outline, double radius) {
  const std::size_t count = outline.size();
  EnclosingRectangle best;
  best.length_along = best.length_across = 2.0 * radius;
  if (count < 2) return best;

  const auto next = [count](std::size_t i) { return i + 1 == count ? 0 : i + 1; };
  // Farthest points ahead, behind and across; they only move on while the edge turns once around.
  // A step that gains nothing is taken too, or points that tie would hold them back.
  std::size_t ahead = 0, behind = 0, across = 0;
  const auto advance = [&](std::size_t& i, const Vec2& direction) {
    for (std::size_t steps = 0; steps < count; ++steps) {
      if (direction.dot(outline[next(i)] - outline[i]) < 0.0) break;
      i = next(i);
    }
  };
  bool first = true;
  for (std::size_t edge = 0; edge < count; ++edge) {
    const Vec2 direction = (outline[next(edge)] - outline[edge]).normalized();
    const Vec2 inward(-direction.y(), direction.x());
    if (first) {
      for (std::size_t i = 1; i < count; ++i) {
        if (direction.dot(outline[i] - outline[ahead]) > 0.0) ahead = i;
        if (direction.dot(outline[i] - outline[behind]) < 0.0) behind = i;
        if (inward.dot(outline[i] - outline[across]) > 0.0) across = i;
      }
    }
    advance(ahead, direction);
    advance(across, inward);
    advance(behind, -direction);
    EnclosingRectangle candidate;
    candidate.direction = direction;
    candidate.length_along = direction.dot(outline[ahead] - outline[behind]) + 2.0 * radius;
    candidate.length_across = inward.dot(outline[across] - outline[edge]) + 2.0 * radius;
    if (first || candidate.area() < best.area()) best = candidate;
    first = false;
  }
  // Calipers that a zigzag of corners in one line has held back measure too little, never too much:
  // if the best is true, so is that no other is smaller.
  const EnclosingRectangle measured = rectangle_along(outline, best.direction, radius);
  if (measured.area() <= (1.0 + kRounding) * best.area()) return measured;
  best = measured;
  for (std::size_t edge = 0; edge < count; ++edge) {
    const Vec2 side = outline[next(edge)] - outline[edge];
    if (!(side.norm() > 0.0)) continue;
    const EnclosingRectangle candidate = rectangle_along(outline, side.normalized(), radius);
    if (candidate.area() < best.area()) best = candidate;
  }
  return best;
}

}  // namespace clast
