#pragma once
/// Closing of narrow gaps between tiles.
#include "terrain/raw_surface.hpp"
#include "terrain/terrain.hpp"

namespace clast::terrain_detail {

/// Closes gaps up to `width` between border edges: near border vertices are merged, and a border
/// vertex near a border edge (T-junction) splits its triangle. Only border vertices move, by at
/// most `width`, and never if a triangle would flip or an edge become non-manifold.
void close_cracks(RawSurface& surface, double width, TerrainReport& report);

/// Notes border vertices within `reach` in plan of the border of another component, without
/// connection: tiles with a gap or step that stays open.
/// @param surface  oriented, repaired
void note_gaps(const RawSurface& surface, double reach, TerrainReport& report);

}  // namespace clast::terrain_detail
