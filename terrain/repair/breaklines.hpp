#pragma once
/// Breaklines: edges of cliffs and roads finer than the grid.
#include <span>

#include "terrain/gdal/map_lines.hpp"
#include "terrain/raw_surface.hpp"
#include "terrain/terrain.hpp"

namespace clast::terrain_detail {

/// Inserts lines as edges of a grid surface, at the heights of the lines. Vertices within a quarter
/// of a cell are moved onto the line (without flipping triangles); other triangles are split.
/// @param cell  shorter cell size of the grid, m
/// @throws InputError  if a line has no heights, lines intersect at different heights, or none is
///                     over the terrain
void add_breaklines(RawSurface& surface, std::span<const MapLine> lines, double cell,
                    TerrainReport& report);

}  // namespace clast::terrain_detail
