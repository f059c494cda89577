#pragma once
/// Smallest rectangle around points of a plane.
#include <span>
#include <vector>

#include "core/types.hpp"

namespace clast {

/// A rectangle by its direction and its sides, each with twice the radius added.
struct Rectangle {
  Vec2 direction = Vec2::UnitX();  ///< of the side `along`, unit
  double along = 0.0, across = 0.0;

  double area() const { return along * across; }
};

/// Extreme points counter-clockwise, without those on an edge. One or two points remain of points
/// at one place or on a line.
std::vector<Vec2> convex_hull_2d(std::vector<Vec2> points);

/// The convex outline of points that run once around it counter-clockwise but for rounding: corners
/// that do not turn left are left out.
std::vector<Vec2> remove_reflex_vertices(std::vector<Vec2> loop);

/// Smallest rectangle around the points, each swept by a disc of `radius`. One side lies on an edge
/// of the outline (Freeman & Shapira 1975), also with a radius: between edges the area has no
/// minimum, since both sides are concave functions of the angle.
/// @param points  at least one
Rectangle smallest_rectangle(std::vector<Vec2> points, double radius);

/// The same of points that are a convex outline, counter-clockwise.
Rectangle smallest_outline_rectangle(std::span<const Vec2> outline, double radius);

}  // namespace clast
