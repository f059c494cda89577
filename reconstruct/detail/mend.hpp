#pragma once
/// The single mends that cleaning a scan is made of.
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "shapes/triangle_mesh.hpp"

namespace clast::detail {

/// Volume by signed tetrahedra about the middle of the bounds; negative when facing inwards.
double signed_volume(const TriangleMesh& closed);

/// Is `point` inside the closed surface? By its winding number, so that it holds for any point and
/// either orientation.
bool encloses(const TriangleMesh& closed, const Vec3& point);

/// Vertices of the first edge with more than two triangles.
/// @pre there is one
std::array<std::uint32_t, 2> first_non_manifold_edge(const TriangleMesh& mesh);

/// Pieces connected over edges, in order of their first triangle, without unused vertices.
std::vector<TriangleMesh> split_components(const TriangleMesh& mesh);

/// Drops both of two triangles with the same corners and opposite turn (a sliver welded flat). Of a
/// surface that is stored two-sided throughout, one side is kept. Returns how many were dropped.
std::size_t drop_opposite_pairs(TriangleMesh& mesh);

struct Orientation {
  std::size_t turned = 0;  ///< triangles that were flipped
  bool orientable = true;
  std::uint32_t conflict = 0;  ///< a vertex where the sides can't agree
};

/// Makes neighbours over edges with two triangles agree; each piece keeps the turn that most of its
/// triangles have.
Orientation orient_consistently(TriangleMesh& mesh);

/// Closes holes of at most `most_edges` border edges by the fan of least area that makes no edge
/// twice. Returns the number of border edges of each.
std::vector<std::size_t> fill_small_holes(TriangleMesh& mesh, std::size_t most_edges);

/// Gives every fan of triangles a vertex of its own. Returns how many vertices were split.
std::size_t split_pinched_vertices(TriangleMesh& mesh);

}  // namespace clast::detail
