#include "terrain/detail/fins.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "core/number_text.hpp"
#include "terrain/detail/mending.hpp"

namespace clast::terrain_detail {
namespace {

// Of the area of the largest piece: a flap larger than this may be the ground itself.
constexpr double kLargestFin = 0.01;

}  // namespace

bool drop_fins(RawSurface& surface, const TriangleLinks& links, TerrainReport& report) {
  TriangleMesh& mesh = surface.mesh;
  const std::vector<std::uint32_t> piece = pieces_of(mesh, links);
  std::vector<double> area(*std::max_element(piece.begin(), piece.end()) + 1u, 0.0);
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::uint32_t>> at_edge;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    area[piece[t]] += area_vector(mesh, t).norm() / 2.0;
    for (std::size_t k = 0; k < 3; ++k) {
      if (links.on_border(t, k)) {
        at_edge[std::minmax(mesh.triangles[t][k], mesh.triangles[t][(k + 1) % 3])].push_back(t);
      }
    }
  }
  std::erase_if(at_edge, [](const auto& edge) { return edge.second.size() < 3; });
  const double largest = *std::max_element(area.begin(), area.end());
  std::vector<bool> dropped(area.size(), false);
  for (const auto& [edge, triangles] : at_edge) {
    for (const std::uint32_t t : triangles) {
      dropped[piece[t]] = area[piece[t]] <= kLargestFin * largest;
    }
  }
  // Where the ground itself would be opened, all that meets there stays, and so on from there.
  for (bool changed = true; changed;) {
    changed = false;
    for (const auto& [edge, triangles] : at_edge) {
      const auto stays = std::count_if(triangles.begin(), triangles.end(),
                                       [&](std::uint32_t t) { return !dropped[piece[t]]; });
      if (stays == 0 || stays == 2) continue;
      for (const std::uint32_t t : triangles) {
        changed = changed || dropped[piece[t]];
        dropped[piece[t]] = false;
      }
    }
  }
  std::size_t kept = 0;
  double dropped_area = 0.0;
  Vec3 first_at = Vec3::Zero();
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    if (dropped[piece[t]]) {
      if (dropped_area == 0.0) first_at = centroid(mesh, t);
      dropped_area += area_vector(mesh, t).norm() / 2.0;
      continue;
    }
    mesh.triangles[kept] = mesh.triangles[t];
    surface.source[kept++] = surface.source[t];
  }
  const auto fins = static_cast<std::size_t>(std::count(dropped.begin(), dropped.end(), true));
  if (fins == 0) return false;
  mesh.triangles.resize(kept);
  surface.source.resize(kept);
  drop_unused_vertices(mesh);
  report.dropped_pieces += fins;
  report.notes.push_back(std::to_string(fins) + " fins of " + with_digits(dropped_area, 3) +
                         " m2 in all, which hung on an edge of the ground, were dropped, the "
                         "first at " +
                         place(first_at));
  return true;
}

}  // namespace clast::terrain_detail
