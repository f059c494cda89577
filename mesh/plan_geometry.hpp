#pragma once
/// Areas and insides of triangles and polygons in the plane.
#include <span>

#include "core/types.hpp"

namespace clast {

/// Twice the area of a triangle, positive if its corners run counter-clockwise: `c` is then on the
/// left of the line from `a` to `b`.
inline double twice_area(const Vec2& a, const Vec2& b, const Vec2& c) {
  return cross(b - a, c - a);
}

/// Area of a polygon that does not cross itself, positive if its corners run counter-clockwise; the
/// first corner may be repeated at the end.
double signed_area(std::span<const Vec2> polygon);

/// True if the point is inside. Points on the line of the polygon belong to one side, always the
/// same. Where a polygon crosses itself, what it goes round twice is outside.
bool is_inside(std::span<const Vec2> polygon, const Vec2& point);

}  // namespace clast
