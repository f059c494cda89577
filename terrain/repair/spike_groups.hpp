#pragma once
/// Spike groups and spikes at borders.
#include "terrain/raw_surface.hpp"
#include "terrain/terrain.hpp"

namespace clast::terrain_detail {

/// Levels spikes that `level_spikes` cannot detect: small groups of adjacent vertices, and single
/// vertices at borders, hole rims or cuts between tiles. A group is bounded by edges steeper than
/// `steepness`. Its distance from the plane through the surrounding ground must exceed two limits:
/// `steepness` times its horizontal distance from that ground, and three times the largest
/// deviation of that ground from the plane. Its vertices are projected onto the plane, or at a cut
/// onto the other tile. Must be called before cracks are closed.
/// @param width  horizontal distance up to which border vertices of two tiles coincide, m
void level_spike_groups(TriangleMesh& mesh, double steepness, double width, TerrainReport& report);

}  // namespace clast::terrain_detail
