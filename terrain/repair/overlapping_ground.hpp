#pragma once
/// Detection and removal of overlapping ground.
#include "terrain/raw_surface.hpp"
#include "terrain/terrain.hpp"

namespace clast::terrain_detail {

/// Checks that upward and downward faces alternate on each vertical through a triangle centroid;
/// two consecutive upward faces are duplicate ground. A small component that overlaps other ground
/// with 90 % of its plan area is removed; folds of less than a thousandth of the plan area are
/// noted.
/// @param surface  oriented
/// @param width  overhangs with less free height than this count as duplicate, m
/// @throws GeometryError  for other duplicate ground, with area and position
void remove_overlapping_ground(RawSurface& surface, double width, TerrainReport& report);

}  // namespace clast::terrain_detail
