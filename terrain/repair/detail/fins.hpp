#pragma once
/// Fins: triangles attached to the surface by a single edge.
#include "mesh/triangle_neighbours.hpp"
#include "terrain/raw_surface.hpp"
#include "terrain/terrain.hpp"

namespace clast::terrain_detail {

/// Removes fins: small parts attached at non-manifold edges whose removal makes all these edges
/// manifold. If it is ambiguous which part is the fin, all are kept.
/// @param links  neighbours of the triangles before the removal
/// @return true if any was removed
bool remove_fins(RawSurface& surface, const TriangleNeighbours& links, TerrainReport& report);

}  // namespace clast::terrain_detail
