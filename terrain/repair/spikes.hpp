#pragma once
/// Spikes, slivers and smoothing.
#include "terrain/raw_surface.hpp"
#include "terrain/terrain.hpp"

namespace clast::terrain_detail {

/// Projects spikes and pits onto the plane through their neighbours. A spike is an inner vertex
/// whose distance from this plane exceeds two limits: `steepness` times the mean horizontal
/// distance of the neighbours, and three times the largest deviation of the two surrounding rings
/// of vertices from the plane. The second limit protects crests. One neighbour is ignored in each
/// comparison, because it may be a spike too. Vertices at borders and overhangs are unchanged.
void level_spikes(RawSurface& surface, double steepness, TerrainReport& report);

/// Counts slivers, which are triangles with a height below 1 mm, and notes the position of the
/// lowest. They are common in survey meshes and harmless for contacts, so that they are kept.
void note_slivers(const RawSurface& surface, TerrainReport& report);

/// Moves each inner vertex `rounds` times halfway to the plane through its neighbours. Vertices at
/// borders and overhangs are fixed. The largest change is noted.
void smooth_surface(TriangleMesh& mesh, int rounds, TerrainReport& report);

}  // namespace clast::terrain_detail
