#include "reconstruct/detail/spikes.hpp"

#include <algorithm>
#include <vector>

#include "shapes/detail/half_edges.hpp"

namespace clast::detail {

namespace {

constexpr double kNeighbourRadii = 1.5;
constexpr double kMedianEdges = 2.5;
/// Passes: a vertex beside a spike looks sound only when that is gone.
constexpr int kPasses = 3;

/// Neighbours of every vertex, behind one another; none for vertices at a border or at an edge of
/// more than two triangles.
struct Neighbours {
  std::vector<std::uint32_t> start, list;
};

Neighbours inner_neighbours(const TriangleMesh& mesh, std::span<const HalfEdge> sorted) {
  std::vector<std::uint32_t> degree(mesh.vertices.size(), 0);
  std::vector<bool> outer(mesh.vertices.size(), false);
  for_each_edge(sorted, [&](std::span<const HalfEdge> sides) {
    for (const std::uint32_t v : {sides[0].low, sides[0].high}) {
      ++degree[v];
      if (sides.size() != 2) outer[v] = true;
    }
  });
  Neighbours result;
  result.start.assign(mesh.vertices.size() + 1, 0);
  for (std::size_t v = 0; v < degree.size(); ++v) {
    result.start[v + 1] = result.start[v] + (outer[v] ? 0 : degree[v]);
  }
  result.list.resize(result.start.back());
  std::vector<std::uint32_t> filled(result.start.begin(), result.start.end() - 1);
  for_each_edge(sorted, [&](std::span<const HalfEdge> sides) {
    if (!outer[sides[0].low]) result.list[filled[sides[0].low]++] = sides[0].high;
    if (!outer[sides[0].high]) result.list[filled[sides[0].high]++] = sides[0].low;
  });
  return result;
}

double median_edge(const TriangleMesh& mesh, std::span<const HalfEdge> sorted) {
  std::vector<double> lengths;
  for_each_edge(sorted, [&](std::span<const HalfEdge> sides) {
    lengths.push_back((mesh.vertices[sides[0].high] - mesh.vertices[sides[0].low]).norm());
  });
  const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
  std::nth_element(lengths.begin(), middle, lengths.end());
  return *middle;
}

}  // namespace

Spikes flatten_spikes(TriangleMesh& mesh) {
  Spikes result;
  if (mesh.triangles.empty()) return result;
  const std::vector<HalfEdge> sorted = sorted_half_edges(mesh);
  if (sorted.empty()) return result;
  const Neighbours around = inner_neighbours(mesh, sorted);
  const double least = kMedianEdges * median_edge(mesh, sorted);
  std::vector<bool> moved(mesh.vertices.size(), false);
  for (int pass = 0; pass < kPasses; ++pass) {
    bool any = false;
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
      const std::uint32_t begin = around.start[v], end = around.start[v + 1];
      if (end - begin < 3) continue;
      Vec3 centroid = Vec3::Zero();
      for (std::uint32_t k = begin; k < end; ++k) centroid += mesh.vertices[around.list[k]];
      centroid /= end - begin;
      const double height = (mesh.vertices[v] - centroid).norm();
      if (height <= least) continue;
      double radius = 0.0;
      for (std::uint32_t k = begin; k < end; ++k) {
        radius += (mesh.vertices[around.list[k]] - centroid).norm();
      }
      if (height <= kNeighbourRadii * radius / (end - begin)) continue;
      if (height > result.highest) {
        result.highest = height;
        result.place = mesh.vertices[v];
      }
      mesh.vertices[v] = centroid;
      any = moved[v] = true;
    }
    if (!any) break;
  }
  result.count = static_cast<std::size_t>(std::count(moved.begin(), moved.end(), true));
  return result;
}

}  // namespace clast::detail
