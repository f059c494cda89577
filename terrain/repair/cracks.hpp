#pragma once
/// Narrow gaps between tiles.
#include "terrain/raw_surface.hpp"
#include "terrain/terrain.hpp"

namespace clast::terrain_detail {

/// Closes gaps up to `width` between border edges: border vertices that near become one, and a
/// border vertex that near to a border edge (a T-junction) becomes a corner of the triangle behind
/// it, which is divided. Only border vertices move, by `width` at most, and none where that would
/// turn a triangle over or make an edge of three triangles.
void close_cracks(RawSurface& surface, double width, TerrainReport& report);

/// Notes border vertices that are within `reach`, in plan, of the border of another component, but
/// apart from it: tiles with a gap or a step between them, which nothing closes.
/// @param surface  oriented, repaired
void note_gaps(const RawSurface& surface, double reach, TerrainReport& report);

}  // namespace clast::terrain_detail
