#include "terrain/repair/detail/fins.hpp"

#include <algorithm>

#include "core/number_text.hpp"
#include "mesh/half_edges.hpp"
#include "mesh/triangle_geometry.hpp"

namespace clast::terrain_detail {
namespace {

// Fraction of the largest component's area; a larger flap may be the ground itself.
constexpr double kMaxFin = 0.01;

/// Triangles of each edge that has more than two.
std::vector<std::vector<std::uint32_t>> crowded_edges(const TriangleMesh& mesh) {
  std::vector<std::vector<std::uint32_t>> edges;
  for_each_edge(sorted_half_edges(mesh), [&](std::span<const HalfEdge> sides) {
    if (sides.size() < 3) return;
    edges.emplace_back();
    for (const HalfEdge& side : sides) edges.back().push_back(side.triangle);
  });
  return edges;
}

}  // namespace

bool remove_fins(RawSurface& surface, const TriangleNeighbours& links, TerrainReport& report) {
  const TriangleMesh& mesh = surface.mesh;
  const std::vector<std::uint32_t> component = manifold_components(links);
  std::vector<double> area(*std::max_element(component.begin(), component.end()) + 1u, 0.0);
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    area[component[t]] += doubled_area_vector(mesh, mesh.triangles[t]).norm() / 2.0;
  }
  const std::vector<std::vector<std::uint32_t>> crowded = crowded_edges(mesh);
  const double largest = *std::max_element(area.begin(), area.end());
  std::vector<bool> dropped(area.size(), false);
  for (const std::vector<std::uint32_t>& triangles : crowded) {
    for (const std::uint32_t t : triangles) {
      dropped[component[t]] = area[component[t]] <= kMaxFin * largest;
    }
  }
  // If a removal would open the ground, all triangles at that edge are kept, and so on.
  for (bool changed = true; changed;) {
    changed = false;
    for (const std::vector<std::uint32_t>& triangles : crowded) {
      const auto stays = std::count_if(triangles.begin(), triangles.end(),
                                       [&](std::uint32_t t) { return !dropped[component[t]]; });
      if (stays == 0 || stays == 2) continue;
      for (const std::uint32_t t : triangles) {
        changed = changed || dropped[component[t]];
        dropped[component[t]] = false;
      }
    }
  }
  const auto fins = static_cast<std::size_t>(std::count(dropped.begin(), dropped.end(), true));
  if (fins == 0) return false;
  std::vector<bool> keep(mesh.triangles.size());
  double dropped_area = 0.0;
  Vec3 first_at = Vec3::Zero();
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    keep[t] = !dropped[component[t]];
    if (keep[t]) continue;
    if (dropped_area == 0.0) first_at = centroid(mesh, mesh.triangles[t]);
    dropped_area += doubled_area_vector(mesh, mesh.triangles[t]).norm() / 2.0;
  }
  retain_triangles(surface, keep);
  report.removed_components += fins;
  report.notes.push_back(
      std::to_string(fins) + " fins of " + format_significant(dropped_area, 3) +
      " m2 in all, which were attached to the ground by one edge, were removed, the first at " +
      format_map_point(first_at));
  return true;
}

}  // namespace clast::terrain_detail
