#pragma once
/// Zone borders as edges of the ground.
#include <span>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace clast::terrain_detail {

/// Divides triangles until every segment, seen from above, runs along edges wherever it lies over
/// the mesh, on every layer of it. New vertices lie on the triangles they divide: the surface stays
/// what it was. Segments closer than a micrometre to a vertex or edge take that instead.
/// @param segments  ends, in the plan of the mesh's own frame; zero-length ones do nothing
/// @return  how many triangles were added
std::size_t insert_edges_along(TriangleMesh& mesh, std::span<const std::array<Vec2, 2>> segments);

}  // namespace clast::terrain_detail
