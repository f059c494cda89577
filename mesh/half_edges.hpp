#pragma once
/// Half-edges of triangles and polygons, sorted by edge. Neighbours, fans, borders, components and
/// topology are derived from them.
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace clast {

/// Half-edge: side of a triangle or polygon. `is_forward` is true if it runs from `low` to `high`.
struct HalfEdge {
  std::uint32_t low = 0, high = 0;  ///< vertices, low < high
  std::uint32_t triangle = 0;       ///< index of the triangle or polygon
  bool is_forward = false;
  std::uint32_t side = 0;  ///< side k runs from vertex k to the next

  std::uint32_t from() const { return is_forward ? low : high; }
  std::uint32_t to() const { return is_forward ? high : low; }
  /// Returns the triangle corner at vertex `low`, where corner 3 t + k is vertex k of triangle t.
  std::uint32_t low_corner() const { return 3 * triangle + (side + (is_forward ? 0 : 1)) % 3; }
  std::uint32_t high_corner() const { return 3 * triangle + (side + (is_forward ? 1 : 0)) % 3; }
  std::uint32_t opposite_corner() const { return 3 * triangle + (side + 2) % 3; }
  bool is_same_edge(const HalfEdge& other) const { return low == other.low && high == other.high; }
};

/// Vertices of an edge as a map key, the smaller index first.
using EdgeKey = std::array<std::uint32_t, 2>;

inline EdgeKey make_edge_key(std::uint32_t a, std::uint32_t b) {
  return a < b ? EdgeKey{a, b} : EdgeKey{b, a};
}

/// True if the triangle has a repeated vertex.
inline bool has_repeated_vertex(const TriangleMesh::Triangle& t) {
  return t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
}

/// Returns the half-edges of a mesh, sorted by edge, then triangle. Triangles with a repeated
/// vertex are skipped.
std::vector<HalfEdge> sorted_half_edges(const TriangleMesh& mesh);

/// Returns the half-edges of polygons, sorted by edge, polygon and side. Sides from a vertex to
/// itself are included, with `low` equal to `high`.
std::vector<HalfEdge> sorted_half_edges(std::span<const std::vector<std::uint32_t>> polygons);

/// Calls `use(sides)` for each edge in order; `sides` are its half-edges.
template <class Use>
void for_each_edge(std::span<const HalfEdge> sorted, Use&& use) {
  for (std::size_t begin = 0; begin < sorted.size();) {
    std::size_t end = begin + 1;
    while (end < sorted.size() && sorted[end].is_same_edge(sorted[begin])) ++end;
    use(sorted.subspan(begin, end - begin));
    begin = end;
  }
}

/// True if these are the half-edges of an interior edge of an oriented manifold.
inline bool is_interior_edge(std::span<const HalfEdge> sides) {
  return sides.size() == 2 && sides[0].is_forward != sides[1].is_forward &&
         sides[0].low != sides[0].high;
}

/// Returns the fan of each corner 3 t + k, which is vertex k of triangle t. A fan is a set of
/// triangles around one vertex that are connected over shared edges. Its id is its smallest corner.
std::vector<std::uint32_t> corner_fans(const TriangleMesh& mesh, std::span<const HalfEdge> sorted);

}  // namespace clast
