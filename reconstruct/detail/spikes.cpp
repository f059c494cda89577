#include "reconstruct/detail/spikes.hpp"

#include <algorithm>
#include <vector>

#include "shapes/detail/half_edges.hpp"

namespace clast::detail {

namespace {

constexpr double kNeighbourRadii = 1.5;
/// A spike is taller than so many median edges of the mesh: than the first in any case, than the
/// second where the surface around it is sound.
constexpr double kTallEdges = 2.5, kLeastEdges = 1.2;
/// Sound: each neighbour is no farther than this share of their mean radius from the centroid of
/// its own other neighbours. The tip of a ridge or of a coarse polyhedron stands among others like
/// it.
constexpr double kSoundNeighbourRadii = 0.5;
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

/// The neighbours of a vertex, one of them left out.
struct Ring {
  Vec3 centroid = Vec3::Zero();
  double radius = 0.0;  ///< mean distance from the centroid, m
  std::size_t count = 0;
};

Ring ring_of(const TriangleMesh& mesh, const Neighbours& around, std::uint32_t vertex,
             std::uint32_t left_out) {
  Ring ring;
  const auto each = [&](const auto& visit) {
    for (std::uint32_t k = around.start[vertex]; k < around.start[vertex + 1]; ++k) {
      if (around.list[k] != left_out) visit(mesh.vertices[around.list[k]]);
    }
  };
  each([&](const Vec3& place) {
    ring.centroid += place;
    ++ring.count;
  });
  if (ring.count == 0) return ring;
  ring.centroid /= static_cast<double>(ring.count);
  each([&](const Vec3& place) { ring.radius += (place - ring.centroid).norm(); });
  ring.radius /= static_cast<double>(ring.count);
  return ring;
}

/// True when all that is known of the surface around the vertex is smooth without it.
bool sound_around(const TriangleMesh& mesh, const Neighbours& around, std::uint32_t vertex) {
  for (std::uint32_t k = around.start[vertex]; k < around.start[vertex + 1]; ++k) {
    const std::uint32_t neighbour = around.list[k];
    const Ring ring = ring_of(mesh, around, neighbour, vertex);
    if (ring.count >= 2 &&
        (mesh.vertices[neighbour] - ring.centroid).norm() > kSoundNeighbourRadii * ring.radius) {
      return false;
    }
  }
  return true;
}

}  // namespace

Spikes flatten_spikes(TriangleMesh& mesh) {
  Spikes result;
  if (mesh.triangles.empty()) return result;
  const std::vector<HalfEdge> sorted = sorted_half_edges(mesh);
  if (sorted.empty()) return result;
  const Neighbours around = inner_neighbours(mesh, sorted);
  const double median = median_edge(mesh, sorted);
  std::vector<bool> moved(mesh.vertices.size(), false);
  for (int pass = 0; pass < kPasses; ++pass) {
    bool any = false;
    for (std::uint32_t v = 0; v < mesh.vertices.size(); ++v) {
      const Ring ring = ring_of(mesh, around, v, v);
      if (ring.count < 3) continue;
      const double height = (mesh.vertices[v] - ring.centroid).norm();
      if (height <= kLeastEdges * median || height <= kNeighbourRadii * ring.radius) continue;
      if (height <= kTallEdges * median && !sound_around(mesh, around, v)) continue;
      if (height > result.highest) {
        result.highest = height;
        result.place = mesh.vertices[v];
      }
      mesh.vertices[v] = ring.centroid;
      any = moved[v] = true;
    }
    if (!any) break;
  }
  result.count = static_cast<std::size_t>(std::count(moved.begin(), moved.end(), true));
  return result;
}

}  // namespace clast::detail
