#pragma once
/// Filling of holes in meshes.
#include "terrain/raw_surface.hpp"
#include "terrain/terrain.hpp"

namespace clast::terrain_detail {

/// Triangulates holes whose bounds are at most `widest` on each side, and reports larger ones. A
/// hole is a border loop with opposite orientation to the outer border: clockwise against the
/// normals along it; or a vertical or narrow loop in a component with a larger border. New
/// triangles have the source of an adjacent triangle.
/// @param surface  consistently oriented components
/// @param slit  mean width of narrow loops, m
void fill_surface_holes(RawSurface& surface, double widest, double slit, TerrainReport& report);

}  // namespace clast::terrain_detail
