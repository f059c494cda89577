#include "mesh/triangle_neighbours.hpp"

#include <algorithm>
#include <utility>

namespace clast {

namespace {

using Triangle = TriangleMesh::Triangle;

/// The sides of a triangle in the order of their edges.
std::array<std::size_t, 3> sides_by_edge(const Triangle& t) {
  std::array<std::size_t, 3> sides = {0, 1, 2};
  const auto key = [&](std::size_t k) { return make_edge_key(t[k], t[(k + 1) % 3]); };
  std::sort(sides.begin(), sides.end(),
            [&](std::size_t a, std::size_t b) { return key(a) < key(b); });
  return sides;
}

}  // namespace

TriangleNeighbours triangle_neighbours(const TriangleMesh& mesh) {
  return triangle_neighbours(mesh, sorted_half_edges(mesh));
}

TriangleNeighbours triangle_neighbours(const TriangleMesh& mesh, std::span<const HalfEdge> sorted) {
  TriangleNeighbours result;
  result.neighbour.assign(mesh.triangles.size(), {kNoIndex, kNoIndex, kNoIndex});
  for_each_edge(sorted, [&](std::span<const HalfEdge> sides) {
    if (sides.size() == 1) {
      ++result.border_edges;
    } else if (sides.size() == 2) {
      result.neighbour[sides[0].triangle][sides[0].side] = sides[1].triangle;
      result.neighbour[sides[1].triangle][sides[1].side] = sides[0].triangle;
    } else if (result.non_manifold_edges++ == 0) {
      result.first_non_manifold_edge = {sides[0].low, sides[0].high};
    }
  });
  return result;
}

std::size_t find_edge_side(const Triangle& triangle, std::uint32_t a, std::uint32_t b) {
  for (std::size_t k = 0; k < 3; ++k) {
    if (make_edge_key(triangle[k], triangle[(k + 1) % 3]) == make_edge_key(a, b)) return k;
  }
  return 3;
}

std::vector<std::uint32_t> manifold_components(const TriangleNeighbours& neighbours) {
  std::vector<std::uint32_t> component(neighbours.neighbour.size(), kNoIndex);
  std::vector<std::uint32_t> open;
  std::uint32_t count = 0;
  for (std::uint32_t seed = 0; seed < component.size(); ++seed) {
    if (component[seed] != kNoIndex) continue;
    component[seed] = count;
    open.assign(1, seed);
    while (!open.empty()) {
      const std::uint32_t t = open.back();
      open.pop_back();
      for (const std::uint32_t other : neighbours.neighbour[t]) {
        if (other == kNoIndex || component[other] != kNoIndex) continue;
        component[other] = count;
        open.push_back(other);
      }
    }
    ++count;
  }
  return component;
}

ConsistentOrientation find_consistent_orientation(const TriangleMesh& mesh,
                                                  const TriangleNeighbours& neighbours) {
  ConsistentOrientation result;
  result.is_flipped.assign(mesh.triangles.size(), false);
  std::vector<bool> seen(mesh.triangles.size(), false);
  for (std::uint32_t seed = 0; seed < mesh.triangles.size(); ++seed) {
    if (seen[seed]) continue;
    seen[seed] = true;
    std::vector<std::uint32_t> component = {seed};
    for (std::size_t i = 0; i < component.size(); ++i) {
      const std::uint32_t here = component[i];
      const Triangle& corners = mesh.triangles[here];
      for (const std::size_t k : sides_by_edge(corners)) {
        const std::uint32_t other = neighbours.neighbour[here][k];
        if (other == kNoIndex) continue;
        const std::uint32_t from = corners[k], to = corners[(k + 1) % 3];
        const Triangle& beside = mesh.triangles[other];
        const bool same_way = beside[find_edge_side(beside, from, to)] == from;
        const bool wanted = result.is_flipped[here] != same_way;
        if (!seen[other]) {
          seen[other] = true;
          result.is_flipped[other] = wanted;
          component.push_back(other);
        } else if (result.is_flipped[other] != wanted && !result.conflict_vertex) {
          result.conflict_vertex = std::min(from, to);
        }
      }
    }
    result.components.push_back(std::move(component));
  }
  return result;
}

void flip_orientation(TriangleMesh& mesh) {
  for (Triangle& t : mesh.triangles) std::swap(t[1], t[2]);
}

}  // namespace clast
