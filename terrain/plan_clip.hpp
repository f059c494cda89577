#pragma once
/// Clipping of polygons in plan.
#include <array>
#include <span>
#include <vector>

#include "core/types.hpp"

namespace clast::terrain_detail {

using PlanTriangle = std::array<Vec2, 3>;

/// Clips a ring to a triangle; empty if they do not overlap. Separate parts of a non-convex ring
/// are connected by coincident edges.
/// @param triangle  counter-clockwise
/// @cite sutherland1974
std::vector<Vec2> clip_to_triangle(std::span<const Vec2> ring, const PlanTriangle& triangle);

/// Returns the signed area of the part of a ring inside a triangle, m^2.
/// @param triangle  counter-clockwise
double clipped_area(std::span<const Vec2> ring, const PlanTriangle& triangle);

}  // namespace clast::terrain_detail
