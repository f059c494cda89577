#include "reconstruct/cloud/cut_out.hpp"

#include <algorithm>
#include <cmath>

#include "core/random.hpp"
#include "mesh/half_edges.hpp"
#include "mesh/sub_mesh.hpp"

namespace clast::reconstruct_detail {

namespace {

constexpr double kSurfacePoints = 60000.0;
constexpr int kEarPasses = 10;

/// Triangles that hang from a rim by one edge are cut off, until none is left.
TriangleMesh without_ears(TriangleMesh mesh) {
  for (int pass = 0; pass < kEarPasses; ++pass) {
    std::vector<int> borders(mesh.triangles.size(), 0);
    const auto sides = sorted_half_edges(mesh);
    for_each_edge(sides, [&](std::span<const HalfEdge> edge) {
      if (edge.size() == 1) ++borders[edge[0].triangle];
    });
    std::vector<bool> keep(mesh.triangles.size());
    for (std::size_t t = 0; t < keep.size(); ++t) keep[t] = borders[t] < 2;
    if (std::find(keep.begin(), keep.end(), false) == keep.end()) break;
    mesh = extract_triangles(mesh, keep);
  }
  return mesh;
}

}  // namespace

std::vector<Vec3> sample_surface_points(const TriangleMesh& mesh) {
  Random random(1);
  std::vector<Vec3> points;
  const double each = surface_area(mesh) / kSurfacePoints;
  for (const auto& [a, b, c] : mesh.triangles) {
    const Vec3 p = mesh.vertices[a], u = mesh.vertices[b] - p, v = mesh.vertices[c] - p;
    const double count = std::floor(0.5 * u.cross(v).norm() / each + random.uniform());
    for (double i = 0.0; i < count; ++i) {
      double s = random.uniform(), r = random.uniform();
      if (s + r > 1.0) s = 1.0 - s, r = 1.0 - r;
      points.push_back(p + s * u + r * v);
    }
  }
  return points;
}

std::vector<SurfaceComponent> extract_nearest_components(const TriangleMesh& sheet,
                                                         const PointTree& tree,
                                                         std::span<const std::uint32_t> block) {
  std::vector<bool> on_block;
  for (const std::uint32_t i : block) {
    if (i >= on_block.size()) on_block.resize(i + 1, false);
    on_block[i] = true;
  }
  const auto belongs = [&](const Vec3& p) {
    const std::uint32_t nearest = tree.nearest_neighbours(p, 1).front().point;
    return nearest < on_block.size() && on_block[nearest];
  };
  std::vector<bool> keep(sheet.triangles.size());
  for (std::size_t t = 0; t < keep.size(); ++t) {
    const auto& [a, b, c] = sheet.triangles[t];
    const Vec3 &p = sheet.vertices[a], &q = sheet.vertices[b], &r = sheet.vertices[c];
    keep[t] = belongs((p + q + r) / 3.0) && belongs(p) && belongs(q) && belongs(r);
  }
  const TriangleMesh rock = extract_triangles(sheet, keep);
  if (rock.triangles.empty()) return {};
  return connected_components(without_ears(rock));
}

}  // namespace clast::reconstruct_detail
