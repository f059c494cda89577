#pragma once
/// Fewer vertices for the same ground.
#include "terrain/raw_surface.hpp"
#include "terrain/terrain.hpp"

namespace clast::terrain_detail {

/// Triangulates anew, from as few of its points as a greedy choice finds, the part of the ground
/// that has one height over every place. Everywhere the new surface is within `tolerance` of the
/// old one, vertically: it is at all vertices and at all crossings of old and new edges, where two
/// surfaces of triangles are farthest apart. The largest distance is in the report. Overhangs,
/// walls and what lies over or under them stay; so do all border edges and edges between files. The
/// new part is a constrained Delaunay triangulation in plan, so that none of its faces turns over.
/// @cite garland1995
/// @param surface  oriented, without double ground
/// @throws GeometryError  border edges that cross in plan
void simplify_surface(RawSurface& surface, double tolerance, TerrainReport& report);

}  // namespace clast::terrain_detail
