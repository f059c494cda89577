#pragma once
/// Simplification of terrain surfaces.
#include "terrain/raw_surface.hpp"
#include "terrain/terrain.hpp"

namespace clast::terrain_detail {

/// Simplifies the single-valued part of the ground by greedy insertion and constrained Delaunay
/// triangulation in plan. The new surface is within `tolerance` of the old one vertically, at all
/// vertices and all intersections of old and new edges, where the distance is largest; it is
/// reported. Overhangs, walls and ground above or below them, border edges and edges between files
/// are kept.
/// @cite garland1995
/// @param surface  oriented, without duplicate ground
/// @throws GeometryError  if border edges intersect in plan
void simplify_surface(RawSurface& surface, double tolerance, TerrainReport& report);

}  // namespace clast::terrain_detail
