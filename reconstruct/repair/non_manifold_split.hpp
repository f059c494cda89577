#pragma once
/// Sheets of a surface that touch along an edge or at a vertex, parted.
#include <span>
#include <vector>

#include "mesh/half_edges.hpp"
#include "mesh/triangle_mesh.hpp"
#include "reconstruct/repair/soup.hpp"

namespace clast::reconstruct_detail {

/// Directions from an edge into its triangles, square to the edge.
/// @param sides  those of one edge, one at least
std::vector<Vec3> triangle_directions(const TriangleMesh& mesh, std::span<const HalfEdge> sides);

/// Edges that were cut, and what became of the triangles.
struct SplitEdges {
  RepairChange split;  ///< counts edges
  /// Of each triangle, the one that it is or that it is half of.
  std::vector<std::uint32_t> source;
};

/// Makes edges of more than two triangles into edges of two, without moving anything: sheets that
/// touch are parted so that each pair bounds rock. Where the sheets meet at both ends of an edge as
/// well, each pair is given a vertex of its own in the middle, so that a closed surface stays
/// closed. Triangles that lie on one another can't be parted, and are dropped.
/// @pre oriented as well as it can be
SplitEdges split_non_manifold_edges(TriangleMesh& mesh);

/// Gives every fan of triangles a vertex of its own. Counts the vertices that were split.
RepairChange split_non_manifold_vertices(TriangleMesh& mesh);

/// Moves vertices that lie on one another (split ones) apart by `distance` each: into the rock
/// where the others lie on the side of the air, out of it where they lie on the side of the rock.
/// @param mesh  closed, outward
void separate_touching_vertices(TriangleMesh& mesh, double distance);

}  // namespace clast::reconstruct_detail
