#pragma once
/// Areas of polygons cut out of one another, in plan.
#include <array>
#include <span>
#include <vector>

#include "core/types.hpp"

namespace clast::terrain_detail {

using PlanTriangle = std::array<Vec2, 3>;

/// The part of a ring that lies in a triangle, as a ring; of one that is not convex, parts are
/// joined by edges that run to and fro. Empty: none.
/// @param triangle  counter-clockwise
/// @cite sutherland1974
std::vector<Vec2> clip_to_triangle(std::span<const Vec2> ring, const PlanTriangle& triangle);

/// Area of the part of a ring that lies in a triangle, with the sign of the ring's own. The
/// edges that join the parts of one that is not convex add nothing to it.
/// @param triangle  counter-clockwise
double clipped_area(std::span<const Vec2> ring, const PlanTriangle& triangle);

}  // namespace clast::terrain_detail
