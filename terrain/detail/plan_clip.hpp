#pragma once
/// Areas of polygons cut out of one another, in plan.
#include <array>
#include <span>
#include <vector>

#include "core/types.hpp"

namespace clast::terrain_detail {

using PlanTriangle = std::array<Vec2, 3>;

/// Positive when the ring runs counter-clockwise, m^2.
double signed_area(std::span<const Vec2> ring);

/// Area of the part of a ring that lies in a triangle, with the sign of the ring's own: by
/// cutting along the three sides one after the other. Of a ring that is not convex the parts come
/// back joined by edges that run to and fro, which add nothing to the area.
/// @param triangle  counter-clockwise
/// @cite sutherland1974
double area_within(std::span<const Vec2> ring, const PlanTriangle& triangle);

}  // namespace clast::terrain_detail
