#pragma once
/// Filling of holes in meshes.
#include "terrain/raw_surface.hpp"
#include "terrain/terrain.hpp"

namespace clast::terrain_detail {

/// Triangulates holes whose bounding box is at most `max_width` on each side, and reports larger
/// ones. A hole is a border loop with the orientation opposite to the outer border. A vertical or
/// narrow loop is a hole if its component has a larger border. New triangles get the source of an
/// adjacent triangle.
/// @param surface  consistently oriented components
/// @param slit  largest mean width of narrow loops, m
void fill_surface_holes(RawSurface& surface, double max_width, double slit, TerrainReport& report);

}  // namespace clast::terrain_detail
