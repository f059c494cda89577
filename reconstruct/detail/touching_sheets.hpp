#pragma once
/// Sheets of a surface that touch along an edge or at a vertex, parted.
#include <span>
#include <vector>

#include "mesh/half_edges.hpp"
#include "mesh/triangle_mesh.hpp"
#include "reconstruct/detail/soup.hpp"

namespace clast::reconstruct_detail {

/// Directions from an edge into its triangles, square to the edge.
/// @param sides  those of one edge, one at least
std::vector<Vec3> wings(const TriangleMesh& mesh, std::span<const HalfEdge> sides);

/// Makes edges of more than two triangles into edges of two, without moving anything: sheets that
/// touch are parted so that each pair bounds rock. Where that can't be, the triangles at the edge
/// are dropped. Counts edges.
/// @pre oriented as well as it can be
Change cut_touching_edges(TriangleMesh& mesh);

/// Gives every fan of triangles a vertex of its own. Counts the vertices that were split.
Change split_pinched_vertices(TriangleMesh& mesh);

/// Moves vertices that lie on one another (split ones) apart by `distance` each: into the rock
/// where the others lie on the side of the air, out of it where they lie on the side of the rock.
/// @param mesh  closed, outward
void part_touching_vertices(TriangleMesh& mesh, double distance);

}  // namespace clast::reconstruct_detail
