#pragma once
/// Triangulation of small loops without new vertices.
#include <cstdint>
#include <optional>
#include <set>
#include <span>
#include <vector>

#include "mesh/half_edges.hpp"
#include "mesh/triangle_mesh.hpp"

namespace clast::reconstruct_detail {

/// Filling of a loop with its volume uncertainty.
struct LoopFilling {
  std::vector<TriangleMesh::Triangle> triangles;
  double area = 0.0;  ///< m^2
  /// Possible decrease and increase of the enclosed volume by the lowest and highest triangulation,
  /// or by the extended planes of the neighbours, m^3; not negative.
  double volume_below = 0.0, volume_above = 0.0;
};

/// Finds the triangulation of a loop with minimum bending (dihedral angle times length, summed over
/// its edges and those of the loop) that repeats no edge of `edges`. Cubic in the number of
/// vertices.
/// @param loop  may visit a vertex several times
/// @param normals  unit normal of the triangle beyond side i, from vertex i to i + 1
/// @param edges  all edges of the mesh
/// @returns empty if every triangulation repeats an edge
/// @cite liepa2003
std::optional<LoopFilling> triangulate_loop(const TriangleMesh& mesh,
                                            std::span<const std::uint32_t> loop,
                                            std::span<const Vec3> normals,
                                            const std::set<EdgeKey>& edges);

/// Volumes (m^3) below and above a flat filling of a loop, of cones up to the extended planes
/// beyond its sides; a convex surface stays within the upper one. Averaged over falling and rising
/// sides; cone heights are limited by the loop's width.
struct TangentConeVolumes {
  double below = 0.0, above = 0.0;
};
TangentConeVolumes tangent_cone_volumes(std::span<const Vec3> border,
                                        std::span<const Vec3> normals);

}  // namespace clast::reconstruct_detail
