#pragma once
/// Smallest enclosing rectangle in the plane (rotating callipers).
#include <span>
#include <vector>

#include "core/types.hpp"

namespace clast {

/// Rectangle by its direction and sides, including twice the radius.
struct Rectangle {
  Vec2 direction = Vec2::UnitX();  ///< unit vector along the side `along`
  double along = 0.0, across = 0.0;

  double area() const { return along * across; }
};

/// Returns the convex hull counter-clockwise, without points on edges; one or two points if the
/// input is a point or collinear.
std::vector<Vec2> convex_hull_2d(std::vector<Vec2> points);

/// Removes vertices that do not turn left from a counter-clockwise outline that is convex but for
/// rounding.
std::vector<Vec2> remove_reflex_vertices(std::vector<Vec2> loop);

/// Returns the smallest rectangle around the points, each swept by a disc of `radius`. One side
/// lies on an edge of the outline (Freeman & Shapira 1975), also with a radius, because the area is
/// concave between edges.
/// @param points  not empty
Rectangle smallest_rectangle(std::vector<Vec2> points, double radius);

/// Returns the smallest rectangle around a convex, counter-clockwise outline.
Rectangle smallest_outline_rectangle(std::span<const Vec2> outline, double radius);

}  // namespace clast
