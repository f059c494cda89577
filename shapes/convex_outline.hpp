#pragma once
/// Convex outlines in the plane.
#include <vector>

#include "core/types.hpp"

namespace clast {

/// Returns the vertices of the convex hull, counter-clockwise, without points on edges. It has one
/// or two points if the input is a single point or collinear.
std::vector<Vec2> convex_hull_2d(std::vector<Vec2> points);

/// Makes an outline convex by removal of vertices that rounding has made reflex or straight.
/// @param loop  counter-clockwise
std::vector<Vec2> remove_reflex_vertices(std::vector<Vec2> loop);

}  // namespace clast
