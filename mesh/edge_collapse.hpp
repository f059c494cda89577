#pragma once
/// Collapsing edges of selected triangles.
#include <cstdint>
#include <span>

#include "mesh/triangle_mesh.hpp"

namespace clast {

/// Collapses the shortest collapsible edge of each of `triangles` (indices) to the best-fit point
/// of the adjacent planes, if the vertex stars are disjoint and the surface stays a manifold
/// without folds. If none can be collapsed, their neighbours are tried.
/// @param mesh  closed 2-manifold
/// @return number of collapsed edges; the mesh is unchanged if it is 0
std::size_t collapse_triangle_edges(TriangleMesh& mesh, std::span<const std::uint32_t> triangles);

}  // namespace clast
