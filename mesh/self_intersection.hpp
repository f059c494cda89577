#pragma once
/// Does a surface pass through itself?
#include <array>
#include <cstdint>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace clast {

/// Pairs of triangles that meet elsewhere than in a shared vertex or edge, or that fold onto a
/// neighbour; smaller number first, sorted. Exact predicates; triangles without area are left out.
/// @throws GeometryError  the mesh is not a consistently wound 2-manifold (borders are allowed)
std::vector<std::array<std::uint32_t, 2>> find_self_intersections(const TriangleMesh& mesh);

}  // namespace clast
