#pragma once
/// Single vertices far off the ground around them.
#include "terrain/raw_surface.hpp"
#include "terrain/terrain.hpp"

namespace clast::terrain_detail {

/// Levels spikes and pits: inner vertices farther from the plane through their neighbours than
/// `steepness` times the mean distance of these in plan, and than three times the farthest of them
/// and of their neighbours: a crest is no row of spikes. One of the vertices around is left out of
/// either comparison, as it may be a spike too. They are put onto the plane. Vertices of the border
/// and of overhangs are left alone: one side of them is not known.
void level_spikes(RawSurface& surface, double steepness, TerrainReport& report);

/// Counts triangles whose smallest height is under 1 mm, with the place of the lowest. They are
/// real in survey meshes and do no harm in contact, so that they stay.
void note_slivers(const RawSurface& surface, TerrainReport& report);

/// Moves every inner vertex `rounds` times halfway to the plane through its neighbours; vertices
/// of the border and of overhangs stay. Notes the largest change.
void smooth_surface(TriangleMesh& mesh, int rounds, TerrainReport& report);

}  // namespace clast::terrain_detail
