#pragma once
/// Collapsing edges of selected triangles.
#include <cstdint>
#include <span>

#include "mesh/triangle_mesh.hpp"

namespace clast {

/// Collapses the shortest collapsible edge of each triangle in `triangles` (indices). The new
/// vertex is the least-squares intersection point of the adjacent planes. The surface stays a
/// manifold without folds. Collapses of one call do not share triangles. If no edge can be
/// collapsed, edges of neighbouring triangles are tried.
/// @param mesh  closed 2-manifold
/// @return number of collapsed edges; the mesh is unchanged if it is 0
std::size_t collapse_triangle_edges(TriangleMesh& mesh, std::span<const std::uint32_t> triangles);

}  // namespace clast
