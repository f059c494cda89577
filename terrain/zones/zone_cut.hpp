#pragma once
/// Insertion of zone borders as edges of the terrain.
#include <span>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace clast::terrain_detail {

/// Splits triangles of a mesh until each segment runs along edges in plan. If the mesh has several
/// layers, all are split. New vertices lie on the split triangles, so that the surface does not
/// change. Segments within a micrometre of a vertex or edge are snapped to it.
/// @param segments  end points in plan, in the frame of the mesh; zero-length segments are ignored
/// @return number of added triangles
std::size_t insert_edges_along_segments(TriangleMesh& mesh,
                                        std::span<const std::array<Vec2, 2>> segments);

}  // namespace clast::terrain_detail
