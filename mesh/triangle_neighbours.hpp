#pragma once
/// Triangle neighbours, manifold components and consistent orientation.
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "mesh/half_edges.hpp"
#include "mesh/triangle_mesh.hpp"

namespace clast {

/// Neighbours of each triangle; side k runs from vertex k to vertex k + 1.
struct TriangleNeighbours {
  /// Neighbour across each side; kNoIndex at borders and non-manifold edges.
  std::vector<std::array<std::uint32_t, 3>> neighbour;
  std::size_t border_edges = 0;
  std::size_t non_manifold_edges = 0;    ///< edges with more than two triangles
  EdgeKey first_non_manifold_edge = {};  ///< undefined if there is none

  bool is_border_side(std::uint32_t triangle, std::size_t side) const {
    return neighbour[triangle][side] == kNoIndex;
  }
};

TriangleNeighbours triangle_neighbours(const TriangleMesh& mesh);
/// Finds the neighbours of each triangle.
/// @param sorted  half-edges of `mesh`
TriangleNeighbours triangle_neighbours(const TriangleMesh& mesh, std::span<const HalfEdge> sorted);

/// Returns the side of `triangle` between vertices `a` and `b` in either order; 3 if there is none.
std::size_t find_edge_side(const TriangleMesh::Triangle& triangle, std::uint32_t a,
                           std::uint32_t b);

/// Returns the component of each triangle. Components are connected over manifold edges and
/// numbered in the order of their first triangles.
std::vector<std::uint32_t> manifold_components(const TriangleNeighbours& neighbours);

/// Consistent orientation of a mesh: the triangles that must be flipped.
struct ConsistentOrientation {
  /// Triangles of each manifold component, in breadth-first order from the smallest index.
  std::vector<std::vector<std::uint32_t>> components;
  std::vector<bool> is_flipped;  ///< faces opposite to the first triangle of its component
  /// Vertex of the first edge at which orientations conflict; empty if the surface is orientable.
  std::optional<std::uint32_t> conflict_vertex;
};

ConsistentOrientation find_consistent_orientation(const TriangleMesh& mesh,
                                                  const TriangleNeighbours& neighbours);

void flip_orientation(TriangleMesh& mesh);

}  // namespace clast
