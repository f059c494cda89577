#pragma once
/// Spikes, slivers and smoothing.
#include "terrain/raw_surface.hpp"
#include "terrain/terrain.hpp"

namespace clast::terrain_detail {

/// Levels spikes and pits: inner vertices farther from the plane through their neighbours than
/// `steepness` times the mean horizontal distance of these, and than three times the largest
/// deviation of the neighbours and theirs, so that crests are kept. One neighbour is ignored in
/// either comparison, because it may be a spike, too. Spikes are projected onto the plane. Vertices
/// at borders and overhangs are unchanged.
void level_spikes(RawSurface& surface, double steepness, TerrainReport& report);

/// Counts triangles with a height below 1 mm, with the position of the lowest. They are common in
/// survey meshes, harmless for contacts, and kept.
void note_slivers(const RawSurface& surface, TerrainReport& report);

/// Moves each inner vertex `rounds` times halfway to the plane through its neighbours; border and
/// overhang vertices are fixed. Notes the largest change.
void smooth_surface(TriangleMesh& mesh, int rounds, TerrainReport& report);

}  // namespace clast::terrain_detail
