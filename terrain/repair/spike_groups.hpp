#pragma once
/// Spike groups and spikes at borders.
#include "terrain/raw_surface.hpp"
#include "terrain/terrain.hpp"

namespace clast::terrain_detail {

/// Levels spikes that `level_spikes` cannot detect: small groups of adjacent vertices, and single
/// vertices at borders, hole rims or cuts between tiles. A group is bounded by edges steeper than
/// `steepness`. Its distance from the plane through the surrounding ground must exceed `steepness`
/// times its horizontal distance, and three times the largest deviation of the surroundings. Its
/// vertices are projected onto the plane, at cuts onto the other tile. To be called before cracks
/// are closed.
/// @param width  horizontal distance up to which border vertices of two tiles coincide, m
void level_spike_groups(TriangleMesh& mesh, double steepness, double width, TerrainReport& report);

}  // namespace clast::terrain_detail
