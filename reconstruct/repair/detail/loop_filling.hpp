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

/// Filling of a loop, and uncertainty of the enclosed volume.
struct LoopFilling {
  std::vector<TriangleMesh::Triangle> triangles;
  double area = 0.0;  ///< m^2
  /// Possible decrease and increase of the enclosed volume, m^3; not negative. They follow from the
  /// lowest and highest triangulation, or from the extended planes of the neighbouring triangles.
  double volume_below = 0.0, volume_above = 0.0;
};

/// Finds the triangulation of a loop with minimum bending that repeats no edge of `edges`. The
/// bending is the sum of dihedral angle times length over its edges, including those of the loop.
/// The time is cubic in the number of vertices.
/// @param loop  may visit a vertex several times
/// @param normals  unit normals; entry i is for the triangle beyond the side from vertex i to i + 1
/// @param edges  all edges of the mesh
/// @returns empty if every triangulation repeats an edge
/// @cite liepa2003
std::optional<LoopFilling> triangulate_loop(const TriangleMesh& mesh,
                                            std::span<const std::uint32_t> loop,
                                            std::span<const Vec3> normals,
                                            const std::set<EdgeKey>& edges);

/// Volumes (m^3) of cones below and above a flat filling of a loop, up to the extended planes of
/// the triangles beyond its sides. A convex surface stays within the upper cone. The height of the
/// cones is limited by the width of the loop.
struct TangentConeVolumes {
  double below = 0.0, above = 0.0;
};
TangentConeVolumes tangent_cone_volumes(std::span<const Vec3> border,
                                        std::span<const Vec3> normals);

}  // namespace clast::reconstruct_detail
