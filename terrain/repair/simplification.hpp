#pragma once
/// Simplification of terrain surfaces.
#include "terrain/raw_surface.hpp"
#include "terrain/terrain.hpp"

namespace clast::terrain_detail {

/// Simplifies the single-valued part of the ground by greedy insertion and constrained Delaunay
/// triangulation in plan. The vertical distance between the new and the old surface is at most
/// `tolerance` everywhere; its maximum is reported. Kept are border edges, edges between files,
/// overhangs and walls, and the ground above and below these.
/// @cite garland1995
/// @param surface  oriented surface without duplicate ground
/// @throws GeometryError  if border edges intersect in plan
void simplify_surface(RawSurface& surface, double tolerance, TerrainReport& report);

}  // namespace clast::terrain_detail
