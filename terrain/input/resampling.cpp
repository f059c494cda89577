#include "terrain/input/resampling.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

#include "core/error.hpp"
#include "core/number_text.hpp"
#include "mesh/triangle_geometry.hpp"
#include "terrain/input/detail/cloud_input.hpp"
#include "terrain/plan_clip.hpp"
#include "terrain/plan_index.hpp"
#include "terrain/repair/surface_repair.hpp"

namespace clast::terrain_detail {
namespace {

/// Faces smaller than a cell, such as the sides of a filled crack, are ignored as invisible.
void check_one_height(const TriangleMesh& mesh, double cell, const std::filesystem::path& path) {
  std::size_t count = 0;
  Vec3 first = Vec3::Zero();
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    if (doubled_area_vector(mesh, mesh.triangles[t]).z() > 0.0) continue;
    Bounds box;
    for (const std::uint32_t v : mesh.triangles[t]) box.include(mesh.vertices[v]);
    const double plan = std::abs(doubled_area_vector(mesh, mesh.triangles[t]).z()) / 2.0;
    if (box.high.z() - box.low.z() <= cell && plan <= cell * cell) continue;
    if (count++ == 0) first = centroid(mesh, mesh.triangles[t]);
  }
  if (count == 0) return;
  throw GeometryError(path.string() + ": " + std::to_string(count) + " of " +
                      std::to_string(mesh.triangles.size()) +
                      " triangles are vertical or overhang, the first at " +
                      format_map_point(first) +
                      "; a grid holds only one height at each point. Leave out resolution, or "
                      "simplify the mesh with a tolerance, which keeps them");
}

/// Numbers of the columns or rows whose centres lie from `low` to `high`.
std::pair<std::size_t, std::size_t> cells_between(double low, double high, double first,
                                                  double step, std::size_t count) {
  const double begin = std::max(0.0, std::ceil((low - first) / step - 1e-9));
  const double end =
      std::min(static_cast<double>(count), std::floor((high - first) / step + 1e-9) + 1.0);
  if (!(begin < end)) return {0, 0};
  return {static_cast<std::size_t>(begin), static_cast<std::size_t>(end)};
}

HeightGrid heights_of(const TriangleMesh& mesh, double cell, const std::filesystem::path& path) {
  const Bounds box = bounds(mesh);
  HeightGrid grid = make_covering_grid(box.low.head<2>(), box.high.head<2>(), cell, path);
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    PlanBox corners;
    for (const std::uint32_t v : mesh.triangles[t]) corners.include(mesh.vertices[v].head<2>());
    const auto [left, right] =
        cells_between(corners.low.x(), corners.high.x(), grid.first_centre.x(), cell, grid.columns);
    const auto [bottom, top] =
        cells_between(corners.low.y(), corners.high.y(), grid.first_centre.y(), cell, grid.rows);
    for (std::size_t row = bottom; row < top; ++row) {
      for (std::size_t column = left; column < right; ++column) {
        const std::optional<double> z = height_on_triangle(mesh, t, grid.centre(column, row));
        double& height = grid.heights[row * grid.columns + column];
        if (z && !(height >= *z)) height = *z;
      }
    }
  }
  return grid;
}

PlanTriangle sampled_plan_triangle(const TriangleMesh& mesh, std::uint32_t triangle) {
  const auto& [a, b, c] = mesh.triangles[triangle];
  return {mesh.vertices[a].head<2>(), mesh.vertices[b].head<2>(), mesh.vertices[c].head<2>()};
}

double plan_area(const TriangleMesh& mesh) {
  double area = 0.0;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
    area += doubled_area_vector(mesh, mesh.triangles[t]).z() / 2.0;
  return area;
}

/// Sources of the triangles of `grid` by the plan area that those of `surface` cover.
std::vector<std::uint16_t> sources_for(const TriangleMesh& grid, const RawSurface& surface) {
  std::vector<std::uint16_t> sources(grid.triangles.size(), surface.source_file.front());
  if (std::all_of(surface.source_file.begin(), surface.source_file.end(),
                  [&](std::uint16_t source) { return source == surface.source_file.front(); })) {
    return sources;
  }
  const PlanIndex index(plan_boxes(surface.mesh));
  const std::vector<PlanBox> boxes = plan_boxes(grid);
  for (std::uint32_t t = 0; t < sources.size(); ++t) {
    const PlanTriangle corners = sampled_plan_triangle(grid, t);
    std::map<std::uint16_t, double> covered;
    for (const std::uint32_t old : index.boxes_near(boxes[t])) {
      covered[surface.source_file[old]] +=
          clipped_area(sampled_plan_triangle(surface.mesh, old), corners);
    }
    double most = -1.0;
    for (const auto& [source, area] : covered) {
      if (area <= most) continue;
      most = area;
      sources[t] = source;
    }
  }
  return sources;
}

/// Notes the largest vertical distance between the vertices of `mesh` and the new surface.
void note_change(const TriangleMesh& mesh, const TriangleMesh& grid, double cell,
                 TerrainReport& report) {
  const PlanIndex index(plan_boxes(grid));
  double largest = 0.0;
  Vec3 largest_at = Vec3::Zero();
  for (const Vec3& vertex : mesh.vertices) {
    for (const std::uint32_t t : index.boxes_near(Vec2(vertex.head<2>()))) {
      const std::optional<double> z = height_on_triangle(grid, t, vertex.head<2>());
      if (!z) continue;
      if (std::abs(*z - vertex.z()) > largest) {
        largest = std::abs(*z - vertex.z());
        largest_at = vertex;
      }
      break;
    }
  }
  std::string note = "resampled to cells of " + format_significant(cell, 9) +
                     " m: " + std::to_string(grid.triangles.size()) + " triangles for " +
                     std::to_string(mesh.triangles.size()) + ", over " +
                     format_significant(plan_area(grid), 6) + " of " +
                     format_significant(plan_area(mesh), 6) +
                     " m2 in plan; vertices of the mesh are up to " +
                     format_significant(largest, 3) + " m above or below it";
  if (largest > 0.0) note += ", as at " + format_map_point(largest_at);
  report.notes.push_back(note);
}

}  // namespace

TriangleMesh grid_highest_surface(const TriangleMesh& mesh, double cell,
                                  const std::filesystem::path& path) {
  return triangulate_grid(heights_of(mesh, cell, path), path);
}

RawSurface resample_surface(const RawSurface& surface, double cell,
                            const std::filesystem::path& path, TerrainReport& report) {
  check_one_height(surface.mesh, cell, path);
  const HeightGrid grid = heights_of(surface.mesh, cell, path);
  RawSurface result{.mesh = triangulate_grid(grid, path),
                    .source_file = {},
                    .crs = surface.crs,
                    .notes = surface.notes,
                    .cell = cell};
  result.source_file = sources_for(result.mesh, surface);
  note_change(surface.mesh, result.mesh, cell, report);
  report.components = 0;  // counted anew, with the border
  orient_upwards(result, report);
  return result;
}

}  // namespace clast::terrain_detail
