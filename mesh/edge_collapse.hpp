#pragma once
/// Edges of chosen triangles drawn together to a point, one star at a time.
#include <cstdint>
#include <span>

#include "mesh/triangle_mesh.hpp"

namespace clast {

/// Collapses the shortest possible edge of each of `triangles` (triangle numbers) to the point that
/// lies best on the planes around, as long as the stars don't touch and the surface stays a
/// manifold that folds nowhere; if none of them can, their neighbours are tried.
/// @param mesh  closed 2-manifold
/// @return how many edges were collapsed; 0 leaves the mesh as it was
std::size_t collapse_triangle_edges(TriangleMesh& mesh, std::span<const std::uint32_t> triangles);

}  // namespace clast
