#include <cmath>
#include <vector>

#include "core/error.hpp"
#include "core/files/text_file.hpp"
#include "core/files/up_axis.hpp"
#include "core/number_text.hpp"
#include "mesh/mesh_io.hpp"
#include "terrain/gdal/geotiff_writer.hpp"
#include "terrain/relief.hpp"
#include "terrain/terrain_file.hpp"

namespace clast {
namespace {

constexpr double kMaxRasterCells = 1e9;

/// Writes the height of the highest surface at cell centres; cell borders are multiples of `cell`.
void write_heights(const std::filesystem::path& path, const Terrain& terrain, double cell,
                   const OverwritePolicy& rules) {
  const Bounds box = bounds(terrain.surface);
  const Vec3 low = terrain.frame.to_map(box.low), high = terrain.frame.to_map(box.high);
  const Vec2 first = (low.head<2>() / cell).array().floor();
  const Vec2 count =
      ((high.head<2>() / cell).array().ceil() - first.array()).max(Eigen::Array2d::Ones());
  if (!(count.prod() < kMaxRasterCells)) {
    throw InputError(path.string() + ": cells of " + format_significant(cell, 6) +
                     " m are too many for this ground; use larger ones");
  }
  const Vec2 south_west = first * cell - terrain.frame.origin.head<2>();
  const Relief relief = sample_relief(terrain, {south_west, south_west + count * cell},
                                      static_cast<std::uint32_t>(count.x()));
  std::vector<float> heights;
  for (const double height : relief.height) {
    heights.push_back(static_cast<float>(height + terrain.frame.origin.z()));
  }
  const Vec2 corner(first.x() * cell, (first.y() + count.y()) * cell);
  terrain_detail::write_geotiff(path,
                                {.columns = static_cast<std::size_t>(count.x()),
                                 .rows = static_cast<std::size_t>(count.y()),
                                 .corner = corner,
                                 .cell = cell,
                                 .values = heights,
                                 .meaning = "height, m"},
                                terrain.frame.crs, rules);
}

}  // namespace

void export_terrain(const std::filesystem::path& path, const Terrain& terrain,
                    const std::string& up_of_user, double cell, const OverwritePolicy& rules) {
  const std::string up = resolve_up_axis(up_of_user, path);
  const std::string extension = lower_case_extension(path);
  if (extension == ".tif" || extension == ".tiff") {
    if (up == "y") throw InputError(path.string() + ": rasters are z up; leave out up = \"y\"");
    if (!(cell > 0.0 && std::isfinite(cell))) {
      throw InputError("cell = " + format_significant(cell, 6) + " m; must be more than 0");
    }
    write_heights(path, terrain, cell, rules);
    return;
  }
  const bool floats = extension == ".stl" || extension == ".glb";
  TriangleMesh mesh = terrain.surface;
  for (Vec3& vertex : mesh.vertices) {
    if (!floats) vertex = terrain.frame.to_map(vertex);
    if (up == "y") vertex = z_up_to_y_up(vertex);
  }
  const auto describe_origin = [&](const Vec3& subtracted) -> std::string {
    const Vec3 origin = terrain.frame.origin + (up == "y" ? y_up_to_z_up(subtracted) : subtracted);
    if (!floats || origin.isZero(0.0)) return "";
    std::string text = "map coordinates (z up) = coordinates here (" + up + " up) + origin, m\n";
    text += kOriginLinePrefix + format_map_point(origin) + "\n";
    if (!terrain.frame.crs.empty()) text += "map system " + terrain.frame.crs + "\n";
    return text;
  };
  write_mesh(path, mesh, {.rules = rules, .describe_origin = describe_origin});
}

}  // namespace clast
