#pragma once
/// Which way the surface through points faces.
#include <cstddef>
#include <span>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace clast::reconstruct_detail {

/// Orients the normals from neighbour to neighbour along the spanning tree with the least change of
/// direction, starting at the point farthest from the centre, whose normal faces away from it.
/// @param normals  unit, of either sign, one for each point
/// @cite hoppe1992
void turn_outward(std::vector<Vec3>& normals, std::span<const Vec3> points);

/// Gives a vertex the normal of its triangles where its own is more than 60 degrees off: it came
/// from points of two sides, or faces in. Counts these.
/// @param surface  outward; its vertices are the points the normals are of
std::size_t correct_normals(std::vector<Vec3>& normals, const TriangleMesh& surface);

}  // namespace clast::reconstruct_detail
