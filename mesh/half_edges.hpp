#pragma once
/// The sides of all triangles, sorted so that those on one edge stand together.
#include <cstdint>
#include <span>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace clast {

/// One side of one triangle. `forward`: the triangle runs from `low` to `high`.
struct HalfEdge {
  std::uint32_t low = 0, high = 0;  ///< vertices, low < high
  std::uint32_t triangle = 0;
  bool forward = false;

  std::uint32_t from() const { return forward ? low : high; }
  std::uint32_t to() const { return forward ? high : low; }
  bool same_edge(const HalfEdge& other) const { return low == other.low && high == other.high; }
};

/// Is a vertex repeated?
inline bool collapsed(const TriangleMesh::Triangle& t) {
  return t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
}

/// Sorted by edge, then triangle. Triangles with a repeated vertex have none.
std::vector<HalfEdge> sorted_half_edges(const TriangleMesh& mesh);

/// Calls `use(sides)` with the half-edges of each edge, in order.
template <class Use>
void for_each_edge(std::span<const HalfEdge> sorted, Use&& use) {
  for (std::size_t begin = 0; begin < sorted.size();) {
    std::size_t end = begin + 1;
    while (end < sorted.size() && sorted[end].same_edge(sorted[begin])) ++end;
    use(sorted.subspan(begin, end - begin));
    begin = end;
  }
}

/// The triangles at each vertex, grouped into fans connected over shared edges. Corner 3 t + k is
/// vertex k of triangle t; the value is the smallest corner of its fan.
std::vector<std::uint32_t> corner_fans(const TriangleMesh& mesh, std::span<const HalfEdge> sorted);

}  // namespace clast
