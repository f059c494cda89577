#include "reconstruct/cloud/detail/observed_surface.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "core/statistics/statistics.hpp"
#include "mesh/mesh_topology.hpp"
#include "mesh/sub_mesh.hpp"

namespace clast::reconstruct_detail {

namespace {

/// Largest empty ball, in point spacings. For n points at random over a surface its radius is about
/// sqrt(ln n / pi) spacings: 1.6 for 3,000 points, 1.9 for 100,000.
constexpr double kMaxBall = 2.5;
/// An edge of a plate that nobody saw is a strip hardly wider than the points are apart, but long:
/// a patch that extends over so many spacings is a hole with balls of this radius.
constexpr double kLongPatch = 12.0, kMaxInLong = 1.75;
/// The sparsest points around a patch, in so many rings: this quantile of their spacings. A stray
/// point or two in the middle of a hole do not make it a sparse area.
constexpr int kSparseRings = 2;
constexpr double kThinnestSeen = 0.85;
/// Holes with less than this share of the area are gaps between points and count as seen.
constexpr double kGapFraction = 0.005;

/// The empty ball over a triangle, as if all its edges had the length of the longest.
double ball_over(const TriangleMesh& mesh, const TriangleMesh::Triangle& t) {
  double longest = 0.0;
  for (std::size_t k = 0; k < 3; ++k) {
    longest = std::max(longest, (mesh.vertices[t[k]] - mesh.vertices[t[(k + 1) % 3]]).norm());
  }
  return longest / std::sqrt(3.0);
}

double spacing_at(std::span<const double> spacings, const TriangleMesh::Triangle& t) {
  const double a = spacings[t[0]], b = spacings[t[1]], c = spacings[t[2]];
  return std::max(std::min(a, b), std::min(std::max(a, b), c));
}

/// Connected triangles with large balls.
struct SparsePatch {
  double area = 0.0;
  double largest = 0.0;          ///< ball, m
  double largest_share = 0.0;    ///< ball over spacing
  Vec3 position = Vec3::Zero();  ///< of that ball
  std::vector<std::uint32_t> points;
};

/// Adds the vertices around those of a patch, ring by ring: at its very border the spacing of thin
/// points is not their own.
void add_rings(std::vector<std::uint32_t>& points, const TriangleMesh& mesh) {
  std::vector<bool> in(mesh.vertices.size(), false);
  for (const std::uint32_t point : points) in[point] = true;
  for (int ring = 0; ring < kSparseRings; ++ring) {
    std::vector<bool> wider = in;
    for (const TriangleMesh::Triangle& t : mesh.triangles) {
      if (!in[t[0]] && !in[t[1]] && !in[t[2]]) continue;
      for (const std::uint32_t v : t) wider[v] = true;
    }
    in = std::move(wider);
  }
  points.clear();
  for (std::uint32_t v = 0; v < in.size(); ++v) {
    if (in[v]) points.push_back(v);
  }
}

/// @returns in spacings, the radius of the ball that makes a patch a hole
double ball_of_hole(const SparsePatch& patch, const TriangleMesh& mesh,
                    std::span<const double> spacings) {
  Bounds box;
  for (const std::uint32_t point : patch.points) box.include(mesh.vertices[point]);
  std::vector<double> own;
  for (const std::uint32_t point : patch.points) own.push_back(spacings[point]);
  std::sort(own.begin(), own.end());
  return box.diagonal() > kLongPatch * quantile(own, 0.5) ? kMaxInLong : kMaxBall;
}

/// @param patch  with the points of the rings around it
/// @param ball   in spacings, that makes it a hole
bool is_hole(const SparsePatch& patch, double ball, std::span<const double> spacings) {
  std::vector<double> around;
  for (const std::uint32_t point : patch.points) around.push_back(spacings[point]);
  const auto thin = around.begin() + static_cast<std::ptrdiff_t>(
                                         kThinnestSeen * static_cast<double>(around.size() - 1));
  std::nth_element(around.begin(), thin, around.end());
  return patch.largest > ball * *thin;
}

}  // namespace

ObservedSurface find_observed_surface(const TriangleMesh& closed, std::span<const double> spacings,
                                      double ball_radius) {
  std::vector<bool> wide;
  std::vector<std::size_t> triangle_indices;
  for (const TriangleMesh::Triangle& t : closed.triangles) {
    wide.push_back(ball_over(closed, t) > ball_radius * spacing_at(spacings, t));
    if (wide.back()) triangle_indices.push_back(wide.size() - 1);
  }
  const std::vector<std::uint32_t> patch_of = triangle_components(extract_triangles(closed, wide));
  std::vector<SparsePatch> patches;
  for (std::size_t i = 0; i < triangle_indices.size(); ++i) {
    if (patch_of[i] >= patches.size()) patches.resize(patch_of[i] + 1);
    SparsePatch& patch = patches[patch_of[i]];
    const TriangleMesh::Triangle& t = closed.triangles[triangle_indices[i]];
    const double ball = ball_over(closed, t), fraction = ball / spacing_at(spacings, t);
    patch.area += triangle_area(closed, t);
    patch.points.insert(patch.points.end(), t.begin(), t.end());
    patch.largest = std::max(patch.largest, ball);
    if (fraction <= patch.largest_share) continue;
    patch.largest_share = fraction;
    patch.position = (closed.vertices[t[0]] + closed.vertices[t[1]] + closed.vertices[t[2]]) / 3.0;
  }
  const double area = surface_area(closed);
  ObservedSurface result;
  double largest = 0.0;
  std::vector<bool> unobserved(patches.size());
  for (std::size_t k = 0; k < patches.size(); ++k) {
    SparsePatch& patch = patches[k];
    if (patch.largest_share <= kMaxInLong) continue;
    const double ball = ball_of_hole(patch, closed, spacings);
    if (patch.largest_share <= ball) continue;
    add_rings(patch.points, closed);
    if (!is_hole(patch, ball, spacings)) continue;
    unobserved[k] = patch.area >= kGapFraction * area;
    if (unobserved[k]) continue;
    ++result.gaps;
    result.gap_fraction += patch.area / area;
    if (patch.area <= largest) continue;
    largest = patch.area;
    result.gap_position = patch.position;
  }
  result.is_observed.assign(closed.triangles.size(), true);
  for (std::size_t i = 0; i < triangle_indices.size(); ++i) {
    if (unobserved[patch_of[i]]) result.is_observed[triangle_indices[i]] = false;
  }
  return result;
}

}  // namespace clast::reconstruct_detail
