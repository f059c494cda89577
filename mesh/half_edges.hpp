#pragma once
/// The sides of all triangles or polygons, sorted so that those on one edge stand together.
///
/// This is the one place where edges are found: neighbours, fans, borders, components and the
/// topology of a mesh are all read from the sorted sides.
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace clast {

/// One side of one triangle or polygon. `forward`: it runs from `low` to `high`.
struct HalfEdge {
  std::uint32_t low = 0, high = 0;  ///< vertices, low < high
  std::uint32_t triangle = 0;       ///< or number of the polygon
  bool forward = false;
  std::uint32_t side = 0;  ///< side k runs from corner k to the next

  std::uint32_t from() const { return forward ? low : high; }
  std::uint32_t to() const { return forward ? high : low; }
  /// Corners of the triangle at both vertices and opposite: 3 t + k is vertex k of triangle t.
  std::uint32_t low_corner() const { return 3 * triangle + (side + (forward ? 0 : 1)) % 3; }
  std::uint32_t high_corner() const { return 3 * triangle + (side + (forward ? 1 : 0)) % 3; }
  std::uint32_t opposite_corner() const { return 3 * triangle + (side + 2) % 3; }
  bool is_same_edge(const HalfEdge& other) const { return low == other.low && high == other.high; }
};

/// Vertices of an edge, the smaller number first: the key by which sets and maps know it.
using EdgeKey = std::array<std::uint32_t, 2>;

inline EdgeKey edge_key(std::uint32_t a, std::uint32_t b) {
  return a < b ? EdgeKey{a, b} : EdgeKey{b, a};
}

/// Is a vertex repeated?
inline bool has_repeated_vertex(const TriangleMesh::Triangle& t) {
  return t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
}

/// Sorted by edge, then triangle. Triangles with a repeated vertex have none.
std::vector<HalfEdge> sorted_half_edges(const TriangleMesh& mesh);

/// The same of polygons: sorted by edge, then polygon, then side. A side from a vertex to itself
/// counts, with `low` equal to `high`.
std::vector<HalfEdge> sorted_half_edges(std::span<const std::vector<std::uint32_t>> polygons);

/// Calls `use(sides)` with the half-edges of each edge, in order.
template <class Use>
void for_each_edge(std::span<const HalfEdge> sorted, Use&& use) {
  for (std::size_t begin = 0; begin < sorted.size();) {
    std::size_t end = begin + 1;
    while (end < sorted.size() && sorted[end].is_same_edge(sorted[begin])) ++end;
    use(sorted.subspan(begin, end - begin));
    begin = end;
  }
}

/// Are these the two sides of an edge inside a closed, oriented surface?
inline bool is_interior_edge(std::span<const HalfEdge> sides) {
  return sides.size() == 2 && sides[0].forward != sides[1].forward && sides[0].low != sides[0].high;
}

/// The triangles at each vertex, grouped into fans connected over shared edges: for every corner,
/// 3 t + k, the smallest corner of its fan.
std::vector<std::uint32_t> corner_fans(const TriangleMesh& mesh, std::span<const HalfEdge> sorted);

}  // namespace clast
