#pragma once
/// Splitting of non-manifold edges and vertices.
#include <span>
#include <vector>

#include "mesh/half_edges.hpp"
#include "mesh/triangle_mesh.hpp"
#include "reconstruct/repair/soup.hpp"

namespace clast::reconstruct_detail {

/// Returns the directions from an edge into its triangles, perpendicular to the edge.
/// @param sides  of one edge, not empty
std::vector<Vec3> triangle_directions(const TriangleMesh& mesh, std::span<const HalfEdge> sides);

/// Split edges and the origin of the triangles.
struct SplitEdges {
  RepairChange split;  ///< counts edges
  /// Original triangle of each triangle.
  std::vector<std::uint32_t> source;
};

/// Splits non-manifold edges into manifold ones without moving vertices: touching sheets are
/// separated so that each pair bounds rock. If sheets also meet at both ends of an edge, each pair
/// gets a vertex at its midpoint, so that closed surfaces stay closed. Overlapping triangles cannot
/// be separated and are removed.
/// @pre oriented as far as possible
SplitEdges split_non_manifold_edges(TriangleMesh& mesh);

/// Splits non-manifold vertices, with one vertex per fan. Counts split vertices.
RepairChange split_non_manifold_vertices(TriangleMesh& mesh);

/// Separates coincident (split) vertices by `distance` each: into the rock if the other sheet is on
/// the air side, otherwise outwards.
/// @param mesh  closed, outward
void separate_touching_vertices(TriangleMesh& mesh, double distance);

}  // namespace clast::reconstruct_detail
