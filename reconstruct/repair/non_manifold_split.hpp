#pragma once
/// Splitting of non-manifold edges and vertices.
#include <span>
#include <vector>

#include "mesh/half_edges.hpp"
#include "mesh/triangle_mesh.hpp"
#include "reconstruct/repair/soup.hpp"

namespace clast::reconstruct_detail {

/// Returns the directions from an edge into its triangles, perpendicular to the edge.
/// @param sides  half-edges of one edge, not empty
std::vector<Vec3> triangle_directions_at_edge(const TriangleMesh& mesh,
                                              std::span<const HalfEdge> sides);

/// Result of splitting non-manifold edges.
struct EdgeSplitResult {
  RepairChange split;  ///< number of split edges
  /// Index of the triangle before splitting, one per triangle.
  std::vector<std::uint32_t> original_triangle;
};

/// Splits non-manifold edges into manifold edges without moving vertices. Touching sheets are
/// separated such that the rock is between the two sheets of each pair. If the sheets also meet at
/// both ends of an edge, each pair gets a vertex at its midpoint, which keeps closed surfaces
/// closed. Overlapping triangles cannot be separated and are removed.
/// @pre the mesh is oriented as far as possible
EdgeSplitResult split_non_manifold_edges(TriangleMesh& mesh);

/// Splits non-manifold vertices into one per fan of triangles. Returns the number of splits.
RepairChange split_non_manifold_vertices(TriangleMesh& mesh);

/// Separates coincident vertices of touching sheets by moving each of them by `distance`. A vertex
/// moves into the rock if the other sheet is outside, and outwards otherwise.
/// @param mesh  closed, outward
void separate_touching_vertices(TriangleMesh& mesh, double distance);

}  // namespace clast::reconstruct_detail
