#include "mesh/half_edges.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <tuple>

#include "core/disjoint_sets.hpp"

namespace clast {

namespace {

/// Sorts sides into the buckets of their lower vertices first: those hold a few each.
/// @param each_face  calls its argument with every face and its number, in order
template <class EachFace>
std::vector<HalfEdge> sort_sides(const EachFace& each_face) {
  const auto each_side = [&](const auto& visit) {
    each_face([&](const auto& corners, std::uint32_t face) {
      const auto count = static_cast<std::uint32_t>(corners.size());
      for (std::uint32_t k = 0; k < count; ++k) {
        const std::uint32_t from = corners[k], to = corners[(k + 1) % count];
        visit(HalfEdge{std::min(from, to), std::max(from, to), face, from < to, k});
      }
    });
  };
  std::vector<std::size_t> start(1, 0);
  each_side([&](const HalfEdge& side) {
    if (side.low + std::size_t{2} > start.size()) start.resize(side.low + std::size_t{2}, 0);
    ++start[side.low + std::size_t{1}];
  });
  std::partial_sum(start.begin(), start.end(), start.begin());
  std::vector<HalfEdge> sides(start.back());
  std::vector<std::size_t> next(start.begin(), start.end() - 1);
  each_side([&](const HalfEdge& side) { sides[next[side.low]++] = side; });
  for (std::size_t v = 0; v + 1 < start.size(); ++v) {
    std::sort(sides.begin() + static_cast<std::ptrdiff_t>(start[v]),
              sides.begin() + static_cast<std::ptrdiff_t>(start[v + 1]),
              [](const HalfEdge& a, const HalfEdge& b) {
                return std::tie(a.high, a.triangle, a.side) < std::tie(b.high, b.triangle, b.side);
              });
  }
  return sides;
}

}  // namespace

std::vector<HalfEdge> sorted_half_edges(const TriangleMesh& mesh) {
  return sort_sides([&](const auto& visit) {
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
      if (!has_repeated_vertex(mesh.triangles[t])) visit(mesh.triangles[t], t);
    }
  });
}

std::vector<HalfEdge> sorted_half_edges(std::span<const std::vector<std::uint32_t>> polygons) {
  return sort_sides([&](const auto& visit) {
    for (std::uint32_t f = 0; f < polygons.size(); ++f) visit(polygons[f], f);
  });
}

std::vector<std::uint32_t> corner_fans(const TriangleMesh& mesh, std::span<const HalfEdge> sorted) {
  DisjointSets fans(3 * mesh.triangles.size());
  for_each_edge(sorted, [&](std::span<const HalfEdge> sides) {
    for (std::size_t i = 1; i < sides.size(); ++i) {
      fans.join(sides[0].low_corner(), sides[i].low_corner());
      fans.join(sides[0].high_corner(), sides[i].high_corner());
    }
  });
  std::vector<std::uint32_t> result(3 * mesh.triangles.size());
  for (std::uint32_t c = 0; c < result.size(); ++c) result[c] = fans.find(c);
  return result;
}

}  // namespace clast
