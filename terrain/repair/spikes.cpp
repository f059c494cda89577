#include "terrain/repair/spikes.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

#include "core/number_text.hpp"
#include "mesh/triangle_geometry.hpp"
#include "mesh/triangle_neighbours.hpp"
#include "terrain/repair/detail/ring_plane.hpp"

namespace clast::terrain_detail {
namespace {

constexpr double kSuspect = 0.5;  // of the steepness, from which a vertex is looked at closely
// Times the farthest of the vertices around from the same plane: a crest is no row of spikes.
constexpr double kAlone = 3.0;
constexpr double kSliverHeight = 1e-3;  // m
constexpr int kSpikeRounds = 3;
constexpr double kSmoothing = 0.5;  // share of the way in one round

/// Ends of the edges at every vertex.
struct Rings {
  std::vector<std::uint32_t> offsets;
  std::vector<std::uint32_t> ends;
  std::vector<bool> on_border;
  std::vector<bool> overhung;  ///< some triangle there is upright or faces down

  std::span<const std::uint32_t> at(std::size_t vertex) const {
    return {ends.data() + offsets[vertex], ends.data() + offsets[vertex + 1]};
  }
};

Rings rings_of(const TriangleMesh& mesh) {
  const TriangleNeighbours links = triangle_neighbours(mesh);
  Rings rings;
  rings.offsets.assign(mesh.vertices.size() + 1, 0);
  rings.on_border.assign(mesh.vertices.size(), false);
  rings.overhung.assign(mesh.vertices.size(), false);
  // Every inner edge is seen from both sides: the lower triangle files it.
  const auto each_end = [&](const auto& visit) {
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t other = links.neighbour[t][k];
        if (other != kNoIndex && other < t) continue;
        const std::uint32_t a = mesh.triangles[t][k], b = mesh.triangles[t][(k + 1) % 3];
        visit(a, b, other == kNoIndex);
        visit(b, a, other == kNoIndex);
      }
    }
  };
  each_end([&](std::uint32_t from, std::uint32_t, bool border) {
    ++rings.offsets[from + 1];
    if (border) rings.on_border[from] = true;
  });
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) rings.offsets[v + 1] += rings.offsets[v];
  rings.ends.resize(rings.offsets.back());
  std::vector<std::uint32_t> next(rings.offsets.begin(), rings.offsets.end() - 1);
  each_end([&](std::uint32_t from, std::uint32_t to, bool) { rings.ends[next[from]++] = to; });
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const Vec3 area = doubled_area_vector(mesh, mesh.triangles[t]);
    if (area.z() > 0.0) continue;
    for (const std::uint32_t v : mesh.triangles[t]) rings.overhung[v] = true;
  }
  return rings;
}

/// Largest distance of the first and second neighbours from the plane, m, without the farthest,
/// which may be a spike too.
double farthest_around(const TriangleMesh& mesh, const Rings& rings, std::uint32_t vertex,
                       const NeighbourPlane& plane) {
  std::vector<std::uint32_t> around(rings.at(vertex).begin(), rings.at(vertex).end());
  for (const std::uint32_t v : rings.at(vertex)) {
    around.insert(around.end(), rings.at(v).begin(), rings.at(v).end());
  }
  std::sort(around.begin(), around.end());
  around.erase(std::unique(around.begin(), around.end()), around.end());
  double first = 0.0, second = 0.0;
  for (const std::uint32_t v : around) {
    if (v == vertex) continue;
    const Vec3 d = mesh.vertices[v] - mesh.vertices[vertex];
    const double on_plane = plane.height_at(d.head<2>());
    const double off = std::abs(mesh.vertices[v].z() - on_plane);
    second = std::max(second, std::min(first, off));
    first = std::max(first, off);
  }
  return second;
}

/// The plane through all neighbours but the one without which they are flattest.
std::optional<NeighbourPlane> plane_without_one(const TriangleMesh& mesh, const Rings& rings,
                                                std::uint32_t vertex) {
  std::optional<NeighbourPlane> best;
  double flattest = 0.0;
  const std::span<const std::uint32_t> ring = rings.at(vertex);
  for (std::size_t left_out = 0; left_out < ring.size(); ++left_out) {
    std::vector<std::uint32_t> others(ring.begin(), ring.end());
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(left_out));
    const std::optional<NeighbourPlane> plane = fit_neighbour_plane(mesh, others, vertex);
    if (!plane) continue;
    double farthest = 0.0;
    for (const std::uint32_t v : others) {
      const Vec3 d = mesh.vertices[v] - mesh.vertices[vertex];
      const double on_plane = plane->height_at(d.head<2>());
      farthest = std::max(farthest, std::abs(mesh.vertices[v].z() - on_plane));
    }
    if (best && farthest >= flattest) continue;
    best = plane;
    flattest = farthest;
  }
  return best;
}

struct Spikes {
  std::size_t levelled = 0, left = 0;
  double farthest = 0.0;  ///< m
  Vec3 farthest_at = Vec3::Zero(), left_at = Vec3::Zero();
};

void level_once(TriangleMesh& mesh, const Rings& rings, double steepness, Spikes& spikes) {
  std::vector<std::pair<double, std::uint32_t>> suspects;
  for (std::uint32_t v = 0; v < mesh.vertices.size(); ++v) {
    if (rings.on_border[v] || rings.overhung[v]) continue;
    const std::optional<NeighbourPlane> plane = fit_neighbour_plane(mesh, rings.at(v), v);
    if (!plane) continue;
    const double off = std::abs(mesh.vertices[v].z() - plane->height);
    if (off > kSuspect * steepness * plane->distance) suspects.emplace_back(-off, v);
  }
  // The farthest first: what stands beside a spike is only suspect as long as that is there.
  std::sort(suspects.begin(), suspects.end());
  for (const auto& [unused, v] : suspects) {
    // A second spike beside it would pull the plane along.
    const std::optional<NeighbourPlane> plane = rings.at(v).size() > 4
                                                    ? plane_without_one(mesh, rings, v)
                                                    : fit_neighbour_plane(mesh, rings.at(v), v);
    if (!plane) continue;
    const double off = std::abs(mesh.vertices[v].z() - plane->height);
    if (off <= steepness * plane->distance) continue;
    if (off <= kAlone * farthest_around(mesh, rings, v, *plane)) {
      if (spikes.left++ == 0) spikes.left_at = mesh.vertices[v];
      continue;
    }
    ++spikes.levelled;
    if (off > spikes.farthest) {
      spikes.farthest = off;
      spikes.farthest_at = mesh.vertices[v];
    }
    mesh.vertices[v].z() = plane->height;
  }
}

}  // namespace

void level_spikes(RawSurface& surface, double steepness, TerrainReport& report) {
  if (!(steepness > 0.0)) return;
  TriangleMesh& mesh = surface.mesh;
  const Rings rings = rings_of(mesh);
  Spikes spikes;
  // A vertex beside a spike protrudes once the spike is removed.
  for (int round = 0; round < kSpikeRounds; ++round) {
    const std::size_t before = spikes.levelled;
    spikes.left = 0;
    level_once(mesh, rings, steepness, spikes);
    if (spikes.levelled == before) break;
  }
  report.levelled_spikes += spikes.levelled;
  if (spikes.left > 0) {
    report.notes.push_back(
        std::to_string(spikes.left) + (spikes.left == 1 ? " vertex stands" : " vertices stand") +
        " far above or below the surrounding ground together with their neighbours, as on crests "
        "and walls; these heights were kept; the first at " +
        format_map_point(spikes.left_at));
  }
  if (spikes.levelled == 0) return;
  report.notes.push_back(std::to_string(spikes.levelled) +
                         " single vertices far above or below all their neighbours were moved to "
                         "the plane through these, the farthest by " +
                         format_significant(spikes.farthest, 3) + " m, at " +
                         format_map_point(spikes.farthest_at));
}

void note_slivers(const RawSurface& surface, TerrainReport& report) {
  const TriangleMesh& mesh = surface.mesh;
  double lowest = kSliverHeight;
  Vec3 lowest_at = Vec3::Zero();
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& [a, b, c] = mesh.triangles[t];
    const std::vector<Vec3>& v = mesh.vertices;
    const double longest = std::sqrt(std::max(
        {(v[b] - v[a]).squaredNorm(), (v[c] - v[b]).squaredNorm(), (v[a] - v[c]).squaredNorm()}));
    const double height = doubled_area_vector(mesh, mesh.triangles[t]).norm() / longest;
    if (height >= kSliverHeight) continue;
    ++report.slivers;
    if (height >= lowest) continue;
    lowest = height;
    lowest_at = centroid(mesh, mesh.triangles[t]);
  }
  if (report.slivers == 0) return;
  report.notes.push_back(std::to_string(report.slivers) +
                         " slivers, triangles less than 1 mm high, were kept; the lowest, " +
                         format_significant(lowest, 2) + " m, at " + format_map_point(lowest_at));
}

void smooth_surface(TriangleMesh& mesh, int rounds, TerrainReport& report) {
  if (rounds == 0) return;
  const Rings rings = rings_of(mesh);
  std::vector<double> heights(mesh.vertices.size());
  std::vector<double> before;
  for (const Vec3& vertex : mesh.vertices) before.push_back(vertex.z());
  for (int round = 0; round < rounds; ++round) {
    for (std::uint32_t v = 0; v < mesh.vertices.size(); ++v) {
      heights[v] = mesh.vertices[v].z();
      if (rings.on_border[v] || rings.overhung[v]) continue;
      const std::optional<NeighbourPlane> plane = fit_neighbour_plane(mesh, rings.at(v), v);
      if (plane) heights[v] += kSmoothing * (plane->height - heights[v]);
    }
    for (std::size_t v = 0; v < heights.size(); ++v) mesh.vertices[v].z() = heights[v];
  }
  double largest = 0.0;
  Vec3 largest_at = mesh.vertices.front();
  for (std::size_t v = 0; v < before.size(); ++v) {
    const double change = std::abs(mesh.vertices[v].z() - before[v]);
    if (change <= largest) continue;
    largest = change;
    largest_at = mesh.vertices[v];
  }
  report.notes.push_back("smoothed " + std::to_string(rounds) + " times; the largest change, " +
                         format_significant(largest, 3) + " m, is at " +
                         format_map_point(largest_at));
}

}  // namespace clast::terrain_detail
