#pragma once
/// Flaps that hang on the ground by an edge.
#include "mesh/triangle_neighbours.hpp"
#include "terrain/raw_surface.hpp"
#include "terrain/terrain.hpp"

namespace clast::terrain_detail {

/// Drops fins: small parts that edges of three or more triangles part from the rest, and without
/// which two triangles are left at each of these. What is not so clear stays, to be refused.
/// @param links  of the surface as it is
/// @return  whether any was dropped
bool remove_fins(RawSurface& surface, const TriangleNeighbours& links, TerrainReport& report);

}  // namespace clast::terrain_detail
