#pragma once
/// Edges of cliffs and roads that a grid is too coarse for.
#include <span>

#include "terrain/gdal/map_lines.hpp"
#include "terrain/raw_surface.hpp"
#include "terrain/terrain.hpp"

namespace clast::terrain_detail {

/// Makes the lines edges of a grid's surface, at the heights of the lines. Vertices nearer than a
/// quarter of a cell move onto the line (no triangle of a grid turns over by that); the rest is
/// divided where a line crosses.
/// @param cell  of the grid, the shorter side, m
/// @throws InputError  a line without heights, lines that cross at different heights, or none over
///                     the ground
void add_breaklines(RawSurface& surface, std::span<const MapLine> lines, double cell,
                    TerrainReport& report);

}  // namespace clast::terrain_detail
