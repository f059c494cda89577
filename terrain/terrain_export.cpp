#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "core/files/text_file.hpp"
#include "core/files/up_axis.hpp"
#include "core/number_text.hpp"
#include "mesh/mesh_io.hpp"
#include "terrain/gdal/gdal_raster.hpp"
#include "terrain/raw_surface.hpp"
#include "terrain/relief.hpp"
#include "terrain/terrain_file.hpp"

namespace clast {
namespace {

constexpr double kMostRasterCells = 1e9;

/// Highest surface over the centres of square cells whose borders lie on multiples of `cell`.
terrain_detail::HeightGrid sampled(const Terrain& terrain, double cell,
                                   const std::filesystem::path& path) {
  const TriangleMesh& mesh = terrain.surface;
  const Bounds box = bounds(mesh);
  const Vec3 low = terrain.frame.map(box.low), high = terrain.frame.map(box.high);
  const Vec2 first = (low.head<2>() / cell).array().floor();
  const Vec2 count = (high.head<2>() / cell).array().ceil() - first.array();
  if (!(count.prod() < kMostRasterCells)) {
    throw InputError(path.string() + ": cells of " + with_digits(cell, 6) +
                     " m are too many for this ground; use larger ones");
  }
  terrain_detail::HeightGrid grid;
  grid.columns = std::max<std::size_t>(1, static_cast<std::size_t>(count.x()));
  grid.rows = std::max<std::size_t>(1, static_cast<std::size_t>(count.y()));
  grid.step = {cell, cell};
  grid.first = (first + Vec2(0.5, 0.5)) * cell;
  grid.heights.resize(grid.columns * grid.rows);
  const Vec2 south_west = first * cell - terrain.frame.origin.head<2>();
  const Vec2 size(static_cast<double>(grid.columns) * cell, static_cast<double>(grid.rows) * cell);
  const Relief relief = clast::sampled(terrain, {south_west, south_west + size},
                                       static_cast<std::uint32_t>(grid.columns));
  for (std::size_t j = 0; j < grid.rows; ++j) {
    for (std::size_t i = 0; i < grid.columns; ++i) {
      grid.heights[j * grid.columns + i] =
          relief.height[(grid.rows - 1 - j) * grid.columns + i] + terrain.frame.origin.z();
    }
  }
  return grid;
}

}  // namespace

void export_terrain(const std::filesystem::path& path, const Terrain& terrain,
                    const std::string& up_of_user, double cell, const OutputRules& rules) {
  const std::string up = up_axis(up_of_user, path);
  const std::string extension = extension_of(path);
  if (extension == ".tif" || extension == ".tiff") {
    if (up == "y") throw InputError(path.string() + ": rasters are z up; leave out up = \"y\"");
    if (!(cell > 0.0 && std::isfinite(cell))) {
      throw InputError("cell = " + with_digits(cell, 6) + " m; must be more than 0");
    }
    terrain_detail::write_geotiff(path, sampled(terrain, cell, path), terrain.frame.crs, rules);
    return;
  }
  const bool floats = extension == ".stl" || extension == ".glb";
  TriangleMesh mesh = terrain.surface;
  for (Vec3& vertex : mesh.vertices) {
    if (!floats) vertex = terrain.frame.map(vertex);
    if (up == "y") vertex = turned_y_up(vertex);
  }
  const auto origin_text = [&](const Vec3& subtracted) -> std::string {
    const Vec3 origin = terrain.frame.origin + (up == "y" ? turned_z_up(subtracted) : subtracted);
    if (!floats || origin.isZero(0.0)) return "";
    std::string text = "map coordinates (z up) = coordinates here (" + up + " up) + origin, m\n";
    text += kOriginLine + place_on_map(origin) + "\n";
    if (!terrain.frame.crs.empty()) text += "map system " + terrain.frame.crs + "\n";
    return text;
  };
  write_mesh(path, mesh, {.rules = rules, .origin_text = origin_text});
}

}  // namespace clast
