#include "terrain/detail/spikes.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

#include "core/number_text.hpp"
#include "terrain/detail/triangle_links.hpp"

namespace clast::detail {
namespace {

// Times the farthest of the vertices around from the same plane: a crest is no row of spikes.
constexpr double kAlone = 3.0;
constexpr double kSliverHeight = 1e-3;  // m
constexpr double kSmoothing = 0.5;      // share of the way in one round

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
  const TriangleLinks links = triangle_links(mesh);
  Rings rings;
  rings.offsets.assign(mesh.vertices.size() + 1, 0);
  rings.on_border.assign(mesh.vertices.size(), false);
  rings.overhung.assign(mesh.vertices.size(), false);
  // Every inner edge is seen from both sides: the lower triangle files it.
  const auto each_end = [&](const auto& visit) {
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t other = links.across[t][k];
        if (other != kNoTriangle && other < t) continue;
        const std::uint32_t a = mesh.triangles[t][k], b = mesh.triangles[t][(k + 1) % 3];
        visit(a, b, other == kNoTriangle);
        visit(b, a, other == kNoTriangle);
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
    const Vec3 area = area_vector(mesh, t);
    if (area.z() > 0.0) continue;
    for (const std::uint32_t v : mesh.triangles[t]) rings.overhung[v] = true;
  }
  return rings;
}

/// The plane z = height + slope . (x, y) about a vertex, by least squares through its neighbours.
struct RingPlane {
  double height = 0.0;  ///< at the vertex, m
  Vec2 slope = Vec2::Zero();
  double distance = 0.0;  ///< of the neighbours in plan, mean, m
};

/// None with fewer than three neighbours, or where they are in line.
std::optional<RingPlane> ring_plane(const TriangleMesh& mesh, std::span<const std::uint32_t> ring,
                                    std::uint32_t vertex) {
  if (ring.size() < 3) return std::nullopt;
  const Vec3& centre = mesh.vertices[vertex];
  Mat3 normal = Mat3::Zero();
  Vec3 right = Vec3::Zero();
  RingPlane plane;
  for (const std::uint32_t v : ring) {
    const Vec3 d = mesh.vertices[v] - centre;
    const Vec3 row(1.0, d.x(), d.y());
    normal += row * row.transpose();
    right += d.z() * row;
    plane.distance += d.head<2>().norm();
  }
  plane.distance /= static_cast<double>(ring.size());
  // Along their narrow side the neighbours must spread by more than a hundredth of the other.
  const double xx = normal(1, 1), xy = normal(1, 2), yy = normal(2, 2);
  const double sum = xx + yy;
  if (!(xx * yy - xy * xy > 1e-4 * sum * sum)) return std::nullopt;
  const Vec3 fit = normal.ldlt().solve(right);
  if (!fit.allFinite()) return std::nullopt;
  plane.height = centre.z() + fit[0];
  plane.slope = fit.tail<2>();
  return plane;
}

/// How far the neighbours and their neighbours are from the plane at most, m.
double farthest_around(const TriangleMesh& mesh, const Rings& rings, std::uint32_t vertex,
                       const RingPlane& plane) {
  double farthest = 0.0;
  const auto measure = [&](std::uint32_t v) {
    if (v == vertex) return;
    const Vec3 d = mesh.vertices[v] - mesh.vertices[vertex];
    const double on_plane = plane.height + plane.slope.dot(d.head<2>());
    farthest = std::max(farthest, std::abs(mesh.vertices[v].z() - on_plane));
  };
  for (const std::uint32_t v : rings.at(vertex)) {
    measure(v);
    for (const std::uint32_t beyond : rings.at(v)) measure(beyond);
  }
  return farthest;
}

bool stands_alone(const TriangleMesh& mesh, std::span<const std::uint32_t> ring,
                  std::uint32_t vertex) {
  const double z = mesh.vertices[vertex].z();
  bool above = true, below = true;
  for (const std::uint32_t v : ring) {
    above = above && mesh.vertices[v].z() < z;
    below = below && mesh.vertices[v].z() > z;
  }
  return above || below;
}

}  // namespace

void level_spikes(RawSurface& surface, double steepness, TerrainReport& report) {
  if (!(steepness > 0.0)) return;
  TriangleMesh& mesh = surface.mesh;
  const Rings rings = rings_of(mesh);
  std::vector<std::pair<std::uint32_t, double>> levelled;
  double farthest = 0.0;
  Vec3 farthest_at = Vec3::Zero();
  for (std::uint32_t v = 0; v < mesh.vertices.size(); ++v) {
    if (rings.on_border[v] || rings.overhung[v] || !stands_alone(mesh, rings.at(v), v)) continue;
    const std::optional<RingPlane> plane = ring_plane(mesh, rings.at(v), v);
    if (!plane) continue;
    const double off = std::abs(mesh.vertices[v].z() - plane->height);
    if (off <= steepness * plane->distance) continue;
    if (off <= kAlone * farthest_around(mesh, rings, v, *plane)) continue;
    levelled.emplace_back(v, plane->height);
    if (off <= farthest) continue;
    farthest = off;
    farthest_at = mesh.vertices[v];
  }
  for (const auto& [v, height] : levelled) mesh.vertices[v].z() = height;
  report.levelled_spikes = levelled.size();
  if (levelled.empty()) return;
  report.notes.push_back(std::to_string(levelled.size()) +
                         " single vertices far above or below all their neighbours were brought "
                         "to the plane through these, the farthest, by " +
                         with_digits(farthest, 3) + " m, at " + place(farthest_at));
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
    const double height = area_vector(mesh, t).norm() / longest;
    if (height >= kSliverHeight) continue;
    ++report.slivers;
    if (height >= lowest) continue;
    lowest = height;
    lowest_at = centroid(mesh, t);
  }
  if (report.slivers == 0) return;
  report.notes.push_back(std::to_string(report.slivers) +
                         " slivers, triangles less than 1 mm high, were kept; the lowest, " +
                         with_digits(lowest, 2) + " m, at " + place(lowest_at));
}

void smooth(TriangleMesh& mesh, int rounds, TerrainReport& report) {
  if (rounds == 0) return;
  const Rings rings = rings_of(mesh);
  std::vector<double> heights(mesh.vertices.size());
  std::vector<double> before;
  for (const Vec3& vertex : mesh.vertices) before.push_back(vertex.z());
  for (int round = 0; round < rounds; ++round) {
    for (std::uint32_t v = 0; v < mesh.vertices.size(); ++v) {
      heights[v] = mesh.vertices[v].z();
      if (rings.on_border[v] || rings.overhung[v]) continue;
      const std::optional<RingPlane> plane = ring_plane(mesh, rings.at(v), v);
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
                         with_digits(largest, 3) + " m, is at " + place(largest_at));
}

}  // namespace clast::detail
