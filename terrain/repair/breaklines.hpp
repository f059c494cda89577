#pragma once
/// Breaklines: lines along cliffs and roads, which are finer than the grid.
#include <span>

#include "terrain/gdal/map_lines.hpp"
#include "terrain/raw_surface.hpp"
#include "terrain/terrain.hpp"

namespace clast::terrain_detail {

/// Inserts lines as edges of a grid surface, at the heights of the lines. Vertices within a quarter
/// of a cell are moved onto it if no triangle flips. Other triangles under the line are split.
/// @param cell  smaller cell size of the grid, m
/// @throws InputError  if a line has no heights, if lines intersect at different heights, or if no
///                     line is over the terrain
void add_breaklines(RawSurface& surface, std::span<const MapLine> lines, double cell,
                    TerrainReport& report);

}  // namespace clast::terrain_detail
