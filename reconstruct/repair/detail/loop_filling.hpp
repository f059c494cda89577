#pragma once
/// Triangles across a small loop, between its own corners.
#include <cstdint>
#include <optional>
#include <set>
#include <span>
#include <vector>

#include "mesh/half_edges.hpp"
#include "mesh/triangle_mesh.hpp"

namespace clast::reconstruct_detail {

/// How a loop was filled, and how much other fillings would differ.
struct LoopFilling {
  std::vector<TriangleMesh::Triangle> triangles;
  double area = 0.0;  ///< m^2
  /// How much less and more the mesh would enclose with the triangulations that lie lowest and
  /// highest, or under the planes that its neighbours lie in, m^3; both at least 0.
  double volume_below = 0.0, volume_above = 0.0;
};

/// Of all triangulations of `loop` that repeat no edge of `edges`, the one with the least bending:
/// the sum of dihedral angle times length over its edges and those of the loop, with the triangles
/// beyond them. No vertex is added or moved. Cubic in the length of the loop.
/// @param loop     may pass a vertex more than once
/// @param normals  of the triangle beyond side i, from corner i to corner i + 1; unit
/// @param edges    all edges of the mesh
/// @returns none where every triangulation repeats an edge
/// @cite liepa2003
std::optional<LoopFilling> triangulate_loop(const TriangleMesh& mesh, std::span<const std::uint32_t> loop,
                                     std::span<const Vec3> normals, const std::set<EdgeKey>& edges);

/// Volumes (m^3) under and over a flat filling of a loop, of the cones up to where the planes
/// beyond its sides pass its middle: a convex surface stays within the upper one. The mean over the
/// sides of those that fall, and of those that rise; no cone is higher than the loop is wide.
struct TangentConeVolumes {
  double below = 0.0, above = 0.0;
};
TangentConeVolumes tangent_cone_volumes(std::span<const Vec3> border, std::span<const Vec3> normals);

}  // namespace clast::reconstruct_detail
