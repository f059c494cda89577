#pragma once
/// Smallest enclosing rectangle in the plane (rotating callipers).
#include <span>
#include <vector>

#include "core/types.hpp"

namespace clast {

/// Rectangle around discs, given by its direction and side lengths.
struct EnclosingRectangle {
  Vec2 direction = Vec2::UnitX();  ///< unit vector along the side `length_along`
  double length_along = 0.0, length_across = 0.0;

  double area() const { return length_along * length_across; }
};

/// Returns the rectangle of smallest area around discs of `radius` at the points. One side lies
/// along an edge of the convex hull (Freeman & Shapira 1975).
/// @param points  not empty
EnclosingRectangle smallest_rectangle(std::vector<Vec2> points, double radius);

/// Returns the smallest rectangle around a convex, counter-clockwise outline.
EnclosingRectangle smallest_outline_rectangle(std::span<const Vec2> outline, double radius);

}  // namespace clast
