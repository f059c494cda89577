#pragma once
/// Fins: triangles attached to the surface by a single edge.
#include "mesh/triangle_neighbours.hpp"
#include "terrain/raw_surface.hpp"
#include "terrain/terrain.hpp"

namespace clast::terrain_detail {

/// Removes fins: small parts attached at non-manifold edges whose removal makes all these edges
/// manifold. Ambiguous parts are kept, to be refused later.
/// @param links  of the surface as it is
/// @return true if any was removed
bool remove_fins(RawSurface& surface, const TriangleNeighbours& links, TerrainReport& report);

}  // namespace clast::terrain_detail
