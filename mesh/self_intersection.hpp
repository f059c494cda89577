#pragma once
/// Detection of self-intersections.
#include <array>
#include <cstdint>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace clast {

/// Finds pairs of triangles that intersect outside a shared vertex or edge, or that fold onto a
/// neighbour. The pairs are sorted, with the smaller index first. Predicates are exact. Degenerate
/// triangles are skipped.
/// @throws GeometryError  if the mesh is not a consistently oriented 2-manifold (borders are
///                        allowed)
std::vector<std::array<std::uint32_t, 2>> find_self_intersections(const TriangleMesh& mesh);

}  // namespace clast
