#include <algorithm>
#include <cmath>
#include <limits>

#include "core/error.hpp"
#include "core/text_file.hpp"
#include "shapes/mesh_io.hpp"
#include "terrain/detail/gdal_raster.hpp"
#include "terrain/detail/raw_surface.hpp"
#include "terrain/terrain_file.hpp"

namespace clast {
namespace {

constexpr double kMostCells = 1e9;

/// Highest surface over the centres of square cells whose borders lie on multiples of `cell`.
detail::HeightGrid sampled(const Terrain& terrain, double cell, const std::filesystem::path& path) {
  const TriangleMesh& mesh = terrain.surface;
  const Bounds box = bounds(mesh);
  const Vec3 low = terrain.frame.map(box.low), high = terrain.frame.map(box.high);
  const Vec2 first = (low.head<2>() / cell).array().floor();
  const Vec2 count = (high.head<2>() / cell).array().ceil() - first.array();
  if (!(count.prod() < kMostCells)) {
    throw InputError(path.string() + ": cells of " + std::to_string(cell) +
                     " m are too many for this ground; use larger ones");
  }
  detail::HeightGrid grid;
  grid.columns = std::max<std::size_t>(1, static_cast<std::size_t>(count.x()));
  grid.rows = std::max<std::size_t>(1, static_cast<std::size_t>(count.y()));
  grid.step = {cell, cell};
  grid.first = (first + Vec2(0.5, 0.5)) * cell;
  grid.heights.assign(grid.columns * grid.rows, std::numeric_limits<double>::quiet_NaN());
  // In the local frame, where nothing is lost to large coordinates.
  const Vec2 local_first = grid.first - terrain.frame.origin.head<2>();
  const auto cells = [&](double from, double to, double start, std::size_t most) {
    const double last = std::min(std::floor((to - start) / cell), static_cast<double>(most) - 1.0);
    const double begin = std::max(std::ceil((from - start) / cell), 0.0);
    return std::pair{static_cast<long>(begin), static_cast<long>(last)};
  };
  for (const auto& [ia, ib, ic] : mesh.triangles) {
    const Vec3 &a = mesh.vertices[ia], &b = mesh.vertices[ib], &c = mesh.vertices[ic];
    const Vec3 ab = b - a, ac = c - a;
    const double area = ab.x() * ac.y() - ab.y() * ac.x();
    if (area == 0.0) continue;  // upright: its neighbours have the heights
    const auto [x_low, x_high] = std::minmax({a.x(), b.x(), c.x()});
    const auto [y_low, y_high] = std::minmax({a.y(), b.y(), c.y()});
    const auto [first_column, last_column] = cells(x_low, x_high, local_first.x(), grid.columns);
    const auto [first_row, last_row] = cells(y_low, y_high, local_first.y(), grid.rows);
    for (long j = first_row; j <= last_row; ++j) {
      for (long i = first_column; i <= last_column; ++i) {
        const double x = local_first.x() + cell * static_cast<double>(i) - a.x();
        const double y = local_first.y() + cell * static_cast<double>(j) - a.y();
        const double v = (x * ac.y() - y * ac.x()) / area;
        const double w = (ab.x() * y - ab.y() * x) / area;
        constexpr double kEdge = -1e-12;  // centres on an edge belong to both sides
        if (v < kEdge || w < kEdge || v + w > 1.0 - kEdge) continue;
        const double height = a.z() + v * ab.z() + w * ac.z() + terrain.frame.origin.z();
        double& known =
            grid.heights[static_cast<std::size_t>(j) * grid.columns + static_cast<std::size_t>(i)];
        if (!(known >= height)) known = height;
      }
    }
  }
  return grid;
}

}  // namespace

void export_terrain(const std::filesystem::path& path, const Terrain& terrain,
                    const std::string& up, double cell) {
  if (up != "z" && up != "y") throw InputError("up = \"" + up + "\"; must be \"z\" or \"y\"");
  const std::string extension = extension_of(path);
  if (extension == ".tif" || extension == ".tiff") {
    if (up == "y") throw InputError(path.string() + ": rasters are z up; leave out up = \"y\"");
    if (!(cell > 0.0 && std::isfinite(cell))) {
      throw InputError("cell = " + std::to_string(cell) + " m; must be more than 0");
    }
    detail::write_geotiff(path, sampled(terrain, cell, path), terrain.frame.crs);
    return;
  }
  const bool floats = extension == ".stl" || extension == ".glb";
  TriangleMesh mesh = terrain.surface;
  for (Vec3& vertex : mesh.vertices) {
    if (!floats) vertex = terrain.frame.map(vertex);
    if (up == "y") vertex = detail::turned_y_up(vertex);
  }
  write_mesh(path, mesh);
  const Vec3& origin = terrain.frame.origin;
  if (floats && !origin.isZero(0.0)) {
    std::string text = "map coordinates (z up) = coordinates here (" + up + " up) + origin, m\n";
    text += "origin " + detail::place(origin) + "\n";
    if (!terrain.frame.crs.empty()) text += "map system " + terrain.frame.crs + "\n";
    write_text_file(path.string() + ".origin.txt", text);
  }
}

}  // namespace clast
