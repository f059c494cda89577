#pragma once
/// Detection and removal of overlapping ground.
#include "terrain/raw_surface.hpp"
#include "terrain/terrain.hpp"

namespace clast::terrain_detail {

/// Checks that upward and downward faces alternate on each vertical line through a triangle
/// centroid. Two consecutive upward faces are duplicate ground. A small component is removed if 90
/// % of its plan area is duplicate ground. Folds below a thousandth of the plan area are noted.
/// @param surface  oriented surface
/// @param width  smallest free height under an overhang, m; lower ones are duplicate ground
/// @throws GeometryError  if there is other duplicate ground; the message gives area and position
void remove_overlapping_ground(RawSurface& surface, double width, TerrainReport& report);

}  // namespace clast::terrain_detail
