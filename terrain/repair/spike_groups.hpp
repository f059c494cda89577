#pragma once
/// Spikes that stand together or at a border.
#include "terrain/raw_surface.hpp"
#include "terrain/terrain.hpp"

namespace clast::terrain_detail {

/// Levels what `level_spikes` can't judge: a few vertices side by side that stand far off the
/// ground around all of them, and single ones on the border, in the rim of a hole or at a cut
/// between tiles. A group is what edges steeper than `steepness` part from the rest. It must be
/// farther off the plane through the ground around it than `steepness` times its distance from
/// that, and than three times the farthest of what is around. Its vertices are put onto the plane;
/// at a cut onto the other tile, so that no crack is left. Goes before cracks are closed.
/// @param width  in plan, up to which border vertices of two tiles are the same place, m
void level_spike_groups(TriangleMesh& mesh, double steepness, double width, TerrainReport& report);

}  // namespace clast::terrain_detail
