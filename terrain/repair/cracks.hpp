#pragma once
/// Closing of narrow gaps between tiles.
#include "terrain/raw_surface.hpp"
#include "terrain/terrain.hpp"

namespace clast::terrain_detail {

/// Closes gaps up to `width` between border edges. Close border vertices are merged. A border
/// vertex near a border edge splits the triangle of that edge (T-junction). Only border vertices
/// move, by at most `width`. None moves if a triangle flips or an edge becomes non-manifold.
void close_cracks(RawSurface& surface, double width, TerrainReport& report);

/// Notes gaps and steps between tiles that remain open: border vertices within `reach` in plan of
/// the border of another component to which they are not connected.
/// @param surface  oriented and repaired surface
void note_gaps(const RawSurface& surface, double reach, TerrainReport& report);

}  // namespace clast::terrain_detail
