#pragma once
/// The triangle across every side, and what follows from that: manifold components, and which
/// triangles face another way than their neighbours.
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "mesh/half_edges.hpp"
#include "mesh/triangle_mesh.hpp"

namespace clast {

/// Side k runs from corner k to corner k + 1.
struct TriangleNeighbours {
  /// kNoIndex: a border, or an edge of more than two triangles.
  std::vector<std::array<std::uint32_t, 3>> neighbour;
  std::size_t border_edges = 0;
  std::size_t non_manifold_edges = 0;    ///< of more than two triangles
  EdgeKey first_non_manifold_edge = {};  ///< meaningless where there is none

  bool is_border_side(std::uint32_t triangle, std::size_t side) const {
    return neighbour[triangle][side] == kNoIndex;
  }
};

TriangleNeighbours triangle_neighbours(const TriangleMesh& mesh);
/// @param sorted  half-edges of `mesh`
TriangleNeighbours triangle_neighbours(const TriangleMesh& mesh, std::span<const HalfEdge> sorted);

/// The side of `triangle` whose corners are `a` and `b`, in either order; 3 when it has none.
std::size_t find_edge_side(const TriangleMesh::Triangle& triangle, std::uint32_t a,
                           std::uint32_t b);

/// Component number of every triangle, connected over edges of two triangles only, so that parts
/// which meet at an edge of more are apart; numbered by first triangle.
std::vector<std::uint32_t> manifold_components(const TriangleNeighbours& neighbours);

/// Which triangles have to be turned over so that neighbours agree.
struct ConsistentOrientation {
  /// Triangles of each manifold component, the smallest number first and then as neighbours reach
  /// them, over the edges of smaller vertices first.
  std::vector<std::vector<std::uint32_t>> components;
  std::vector<bool> is_flipped;  ///< faces the other way than the first triangle of its component
  /// A vertex of the first edge at which the sides can't agree: the surface is one-sided. None: it
  /// can be oriented.
  std::optional<std::uint32_t> conflict_vertex;
};

ConsistentOrientation find_consistent_orientation(const TriangleMesh& mesh,
                                                  const TriangleNeighbours& neighbours);

/// Makes every triangle face the other way.
void flip_orientation(TriangleMesh& mesh);

}  // namespace clast
