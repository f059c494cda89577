#pragma once
/// Area and point-in-polygon tests in the plane.
#include <span>

#include "core/types.hpp"

namespace clast {

/// Returns twice the signed area of a triangle, positive if its vertices are counter-clockwise.
inline double twice_area(const Vec2& a, const Vec2& b, const Vec2& c) {
  return cross(b - a, c - a);
}

/// Returns the signed area of a simple polygon, positive if its vertices are counter-clockwise. The
/// first vertex may be repeated at the end.
double signed_area(std::span<const Vec2> polygon);

/// True if the point is inside by the even-odd rule. A point on the boundary of adjacent polygons
/// is inside exactly one of them.
bool is_inside(std::span<const Vec2> polygon, const Vec2& point);

}  // namespace clast
