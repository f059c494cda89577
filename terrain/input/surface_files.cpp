#include "terrain/input/surface_files.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "core/files/text_file.hpp"
#include "core/files/up_axis.hpp"
#include "core/number_text.hpp"
#include "mesh/mesh_io.hpp"
#include "mesh/point_cloud.hpp"
#include "terrain/gdal/gdal_raster.hpp"
#include "terrain/input/detail/cloud_input.hpp"
#include "terrain/input/detail/fill_values.hpp"
#include "terrain/input/detail/grid_holes.hpp"
#include "terrain/input/resampling.hpp"

namespace clast::terrain_detail {
namespace {

namespace fs = std::filesystem;

SurfaceKind kind_of(const fs::path& path) {
  const std::string extension = lower_case_extension(path);
  if (extension == ".h5" || extension == ".hdf5") return SurfaceKind::kTerrain;
  if (is_raster_file(path)) return SurfaceKind::kRaster;
  const std::vector<std::string>& clouds = cloud_extensions();
  if (std::find(clouds.begin(), clouds.end(), extension) != clouds.end()) {
    return SurfaceKind::kCloud;
  }
  const std::vector<std::string>& meshes = readable_mesh_extensions();
  if (std::find(meshes.begin(), meshes.end(), extension) != meshes.end()) return SurfaceKind::kMesh;
  throw InputError(path.string() +
                   ": a ground must be a mesh (stl, ply, obj, ...), a raster (tif, asc, "
                   "...), a cloud (las, xyz, txt, csv, pts, pcd) or a terrain file (h5), not \"" +
                   extension + "\"; convert other rasters with gdal_translate " +
                   path.filename().string() + " ground.tif");
}

RawSurface read_meshes(const TerrainOptions& options) {
  RawSurface surface;
  for (std::size_t i = 0; i < options.surface.size(); ++i) {
    TriangleMesh mesh = read_mesh(options.surface[i]);
    if (resolve_up_axis(options.up, options.surface[i]) == "y") {
      for (Vec3& vertex : mesh.vertices) vertex = y_up_to_z_up(vertex);
    }
    surface.source_file.insert(surface.source_file.end(), mesh.triangles.size(),
                               static_cast<std::uint16_t>(i));
    surface.mesh = merged(std::move(surface.mesh), mesh);
  }
  return surface;
}

RawSurface surface_of(const HeightGrid& grid, const fs::path& path) {
  RawSurface surface;
  surface.mesh = triangulate_grid(grid, path);
  surface.source_file.assign(surface.mesh.triangles.size(), 0);
  surface.cell = grid.cell_size.minCoeff();
  const auto empty = std::count_if(grid.heights.begin(), grid.heights.end(),
                                   [](double height) { return !std::isfinite(height); });
  if (empty > 0) {
    surface.notes.push_back(path.string() + ": " + std::to_string(empty) + " of " +
                            std::to_string(grid.heights.size()) +
                            " cells have no height; the ground is left out there");
  }
  return surface;
}

std::string cells_of(double size) { return "cells of " + format_significant(size, 6) + " m"; }

RawSurface read_one_raster(const TerrainOptions& options) {
  const fs::path& path = options.surface.front();
  Raster raster = read_raster(path);
  check_height_unit(path, raster.unit);
  std::vector<std::string> notes =
      check_fill_values(raster.grid, path,
                        {.declared = raster.no_data,
                         .advice = "declare it first: gdal_translate -a_nodata NUMBER " +
                                   path.filename().string() + " ground.tif"});
  for (const std::string& note : raster.notes) notes.push_back(path.string() + ": " + note);
  if (options.resolution) {
    const HeightGrid& grid = raster.grid;
    const double own = grid.cell_size.maxCoeff();
    if (*options.resolution < own * (1.0 - 1e-9)) {
      throw InputError(
          path.string() + ": resolution = " + format_significant(*options.resolution, 6) +
          " m is finer than the raster, which has " + cells_of(own) + "; leave it out");
    }
    std::vector<Vec3> points;
    for (std::size_t i = 0; i < grid.heights.size(); ++i) {
      if (!std::isfinite(grid.heights[i])) continue;
      const Vec2 centre = grid.centre(i % grid.columns, i / grid.columns);
      points.emplace_back(centre.x(), centre.y(), grid.heights[i]);
    }
    if (points.empty()) {
      throw InputError(path.string() +
                       ": holds no heights, only nodata; check which value stands for no data");
    }
    raster.grid = grid_mean_heights(points, *options.resolution, path);
    notes.push_back(path.string() + ": resampled to means over " + cells_of(*options.resolution));
  } else if (std::none_of(raster.grid.heights.begin(), raster.grid.heights.end(),
                          [](double height) { return std::isfinite(height); })) {
    throw InputError(path.string() +
                     ": holds no heights, only nodata; check which value stands for no data");
  }
  if (options.fill) {
    const HoleFillReport filled = fill_grid_holes(raster.grid, *options.fill);
    if (filled.cells > 0) {
      notes.push_back(path.string() + ": " + std::to_string(filled.cells) +
                      " cells without a height were filled from their surroundings, in " +
                      std::to_string(filled.holes) + " holes");
    }
  }
  RawSurface surface = surface_of(raster.grid, path);
  surface.crs = raster.crs;
  surface.notes.insert(surface.notes.begin(), notes.begin(), notes.end());
  return surface;
}

RawSurface read_clouds(const TerrainOptions& options) {
  CloudGrid cloud = read_cloud_grid(options);
  RawSurface surface = surface_of(cloud.grid, options.surface.front());
  surface.crs = std::move(cloud.crs);
  const std::vector<std::string> fill = check_fill_values(
      cloud.grid, options.surface.front(), {.advice = "leave out the points with that height"});
  cloud.notes.insert(cloud.notes.end(), fill.begin(), fill.end());
  surface.notes.insert(surface.notes.begin(), cloud.notes.begin(), cloud.notes.end());
  return surface;
}

}  // namespace

SurfaceKind detect_surface_kind(const std::vector<fs::path>& files) {
  const SurfaceKind kind = kind_of(files.front());
  for (const fs::path& file : files) {
    if (kind_of(file) != kind) {
      throw InputError(files.front().string() + " and " + file.string() +
                       ": meshes, rasters and clouds can't be mixed in one ground; give one kind");
    }
  }
  if (files.size() > 1 && kind == SurfaceKind::kRaster) {
    throw InputError(
        files[1].string() +
        ": a ground is one raster; join the tiles first (gdalbuildvrt ground.vrt ...)");
  }
  if (files.size() > 1 && kind == SurfaceKind::kTerrain) {
    throw InputError(files[1].string() +
                     ": a ground is one terrain file; make one terrain file from all surveys");
  }
  return kind;
}

RawSurface read_surface(const TerrainOptions& options, SurfaceKind kind) {
  if (kind == SurfaceKind::kMesh) return read_meshes(options);
  return kind == SurfaceKind::kRaster ? read_one_raster(options) : read_clouds(options);
}

}  // namespace clast::terrain_detail
