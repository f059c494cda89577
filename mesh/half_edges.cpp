#include "mesh/half_edges.hpp"

#include <algorithm>
#include <tuple>

#include "core/disjoint_sets.hpp"

namespace clast {

std::vector<HalfEdge> sorted_half_edges(const TriangleMesh& mesh) {
  std::vector<HalfEdge> sides;
  sides.reserve(3 * mesh.triangles.size());
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const TriangleMesh::Triangle& corners = mesh.triangles[t];
    if (collapsed(corners)) continue;
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t from = corners[k], to = corners[(k + 1) % 3];
      sides.push_back({std::min(from, to), std::max(from, to), t, from < to});
    }
  }
  std::sort(sides.begin(), sides.end(), [](const HalfEdge& a, const HalfEdge& b) {
    return std::tie(a.low, a.high, a.triangle) < std::tie(b.low, b.high, b.triangle);
  });
  return sides;
}

std::vector<std::uint32_t> corner_fans(const TriangleMesh& mesh, std::span<const HalfEdge> sorted) {
  DisjointSets fans(3 * mesh.triangles.size());
  const auto corner = [&](std::uint32_t triangle, std::uint32_t vertex) {
    const TriangleMesh::Triangle& t = mesh.triangles[triangle];
    return 3 * triangle + (t[0] == vertex ? 0u : t[1] == vertex ? 1u : 2u);
  };
  for_each_edge(sorted, [&](std::span<const HalfEdge> sides) {
    for (std::size_t i = 1; i < sides.size(); ++i) {
      for (const std::uint32_t vertex : {sides[0].low, sides[0].high}) {
        fans.join(corner(sides[0].triangle, vertex), corner(sides[i].triangle, vertex));
      }
    }
  });
  std::vector<std::uint32_t> result(3 * mesh.triangles.size());
  for (std::uint32_t c = 0; c < result.size(); ++c) result[c] = fans.find(c);
  return result;
}

}  // namespace clast
