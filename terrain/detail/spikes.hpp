#pragma once
/// Single vertices far off the ground around them.
#include "terrain/detail/raw_surface.hpp"
#include "terrain/terrain.hpp"

namespace clast::detail {

/// Levels spikes and pits: inner vertices above all their neighbours or below all of them, and
/// farther from the plane through these than `steepness` times their mean distance in plan and than
/// three times the farthest of them and of their neighbours: a crest is no row of spikes. They are
/// put onto the plane. Vertices of the border and of overhangs are left alone: one side of them is
/// not known.
void level_spikes(RawSurface& surface, double steepness, TerrainReport& report);

/// Counts triangles whose smallest height is under 1 mm, with the place of the lowest. They are
/// real in survey meshes and do no harm in contact, so that they stay.
void note_slivers(const RawSurface& surface, TerrainReport& report);

/// Moves every inner vertex `rounds` times halfway to the plane through its neighbours; vertices
/// of the border and of overhangs stay. Notes the largest change.
void smooth(TriangleMesh& mesh, int rounds, TerrainReport& report);

}  // namespace clast::detail
