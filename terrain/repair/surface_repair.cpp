#include "terrain/repair/surface_repair.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "core/number_text.hpp"
#include "mesh/sub_mesh.hpp"
#include "mesh/triangle_geometry.hpp"
#include "mesh/triangle_neighbours.hpp"
#include "mesh/weld.hpp"
#include "terrain/repair/detail/fins.hpp"

namespace clast::terrain_detail {
namespace {

constexpr double kWeldDistance = 1e-6;  // m
constexpr double kMinHeight = 1e-9;     // m, of a triangle over its longest edge
constexpr double kWallFraction = 1e-6;  // of plan area in area, under which a component is a wall

using Triangle = TriangleMesh::Triangle;

bool is_degenerate(const TriangleMesh& mesh, const Triangle& t) {
  const Vec3 &a = mesh.vertices[t[0]], &b = mesh.vertices[t[1]], &c = mesh.vertices[t[2]];
  const double longest = std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()});
  return !(doubled_area_vector(mesh, t).norm() >= kMinHeight * longest) || longest == 0.0;
}

/// Marks all but the first of triangles with the same corners.
/// @throws GeometryError  two of them have different zones
std::vector<bool> copies_of_triangles(const RawSurface& surface,
                                      const std::vector<std::string>& files,
                                      const std::vector<std::uint16_t>& zone_of_file) {
  const TriangleMesh& mesh = surface.mesh;
  std::vector<bool> is_copy(mesh.triangles.size(), false);
  for (const auto& [one, two] : find_duplicate_triangles(mesh.triangles, WindingMatch::kEither)) {
    is_copy[two] = true;
    const std::uint16_t file = surface.source_file[one], other = surface.source_file[two];
    if (zone_of_file[file] != zone_of_file[other] && !is_degenerate(mesh, mesh.triangles[one])) {
      throw GeometryError(files[file] + " and " + files[other] + " both hold the triangle at " +
                          format_map_point(centroid(mesh, mesh.triangles[one])) +
                          " under different zones; cut it out of one of them");
    }
  }
  return is_copy;
}

/// True if an oriented component faces up over most of its plan area; empty if vertical.
std::optional<bool> faces_up(const TriangleMesh& mesh, const std::vector<std::uint32_t>& component,
                             const std::vector<bool>& against) {
  double plan = 0.0, area = 0.0;
  for (const std::uint32_t t : component) {
    const Vec3 normal = doubled_area_vector(mesh, mesh.triangles[t]);
    plan += against[t] ? -normal.z() : normal.z();
    area += normal.norm();
  }
  if (std::abs(plan) < kWallFraction * area) return std::nullopt;
  return plan >= 0.0;
}

}  // namespace

void weld_surface(RawSurface& surface, TerrainReport& report) {
  TriangleMesh& mesh = surface.mesh;
  const std::vector<std::uint32_t> target = find_weld_targets(mesh.vertices, kWeldDistance);
  for (std::uint32_t v = 0; v < target.size(); ++v) report.welded_vertices += target[v] != v;
  for (Triangle& t : mesh.triangles) {
    for (std::uint32_t& corner : t) corner = target[corner];
  }
}

void remove_invalid_triangles(RawSurface& surface, const std::vector<std::string>& files,
                              const std::vector<std::uint16_t>& zone_of_file,
                              TerrainReport& report) {
  TriangleMesh& mesh = surface.mesh;
  const std::vector<bool> is_copy = copies_of_triangles(surface, files, zone_of_file);
  std::vector<bool> keep(mesh.triangles.size(), true);
  Vec3 degenerate_at = Vec3::Zero(), copy_at = Vec3::Zero();
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const Triangle& triangle = mesh.triangles[t];
    const bool degenerate = is_degenerate(mesh, triangle);
    keep[t] = !degenerate && !is_copy[t];
    if (degenerate) {
      if (report.removed_degenerate++ == 0) degenerate_at = centroid(mesh, triangle);
    } else if (is_copy[t]) {
      if (report.removed_duplicates++ == 0) copy_at = centroid(mesh, triangle);
    }
  }
  retain_triangles(surface, keep);
  if (mesh.triangles.empty()) {
    throw GeometryError(files[0] + ": no triangle has an area, so there is no ground");
  }
  const auto note = [&](std::size_t dropped, const std::string& what, const Vec3& at) {
    if (dropped == 0) return;
    report.notes.push_back(std::to_string(dropped) + what + " were removed, the first at " +
                           format_map_point(at));
  };
  note(report.removed_degenerate, " triangles without an area", degenerate_at);
  note(report.removed_duplicates, " copies of triangles", copy_at);
}

void orient_upwards(RawSurface& surface, TerrainReport& report) {
  TriangleMesh& mesh = surface.mesh;
  TriangleNeighbours links = triangle_neighbours(mesh);
  if (links.non_manifold_edges > 0 && remove_fins(surface, links, report)) {
    links = triangle_neighbours(mesh);
  }
  report.boundary_edges = links.border_edges;
  if (links.non_manifold_edges > 0) {
    const auto& [low, high] = links.first_non_manifold_edge;
    throw GeometryError("the ground has " + std::to_string(links.non_manifold_edges) +
                        " edges where more than two triangles meet, the first at " +
                        format_map_point((mesh.vertices[low] + mesh.vertices[high]) / 2.0) +
                        "; surfaces overlap or cross there, remove one of them");
  }
  const ConsistentOrientation facing = find_consistent_orientation(mesh, links);
  if (facing.conflict_vertex) {
    throw GeometryError("the ground at " +
                        format_map_point(mesh.vertices[*facing.conflict_vertex]) +
                        " is a twisted surface without an upper side; cut it there");
  }
  report.components += facing.components.size();
  std::vector<bool> turn = facing.is_flipped;
  for (const std::vector<std::uint32_t>& component : facing.components) {
    const std::optional<bool> up = faces_up(mesh, component, facing.is_flipped);
    if (!up) {
      report.notes.push_back(
          "a component of " + std::to_string(component.size()) + " triangles at " +
          format_map_point(centroid(mesh, mesh.triangles[component.front()])) +
          " is vertical and touches no other ground, so the orientation in the file was used");
    } else if (!*up) {
      for (const std::uint32_t t : component) turn[t] = !turn[t];
    }
  }
  Vec3 first_turned = Vec3::Zero();
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    if (!turn[t]) continue;
    if (report.flipped_triangles++ == 0) first_turned = centroid(mesh, mesh.triangles[t]);
    std::swap(mesh.triangles[t][1], mesh.triangles[t][2]);
  }
  if (report.flipped_triangles > 0) {
    report.notes.push_back(std::to_string(report.flipped_triangles) +
                           " triangles faced into the ground and were reversed, the first at " +
                           format_map_point(first_turned));
  }
}

}  // namespace clast::terrain_detail
