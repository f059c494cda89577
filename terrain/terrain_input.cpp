#include "terrain/terrain_input.hpp"

#include <algorithm>
#include <cmath>

#include "core/digest.hpp"
#include "core/error.hpp"
#include "core/input_file.hpp"
#include "core/number_text.hpp"
#include "core/text_file.hpp"
#include "mesh/mesh_io.hpp"
#include "mesh/point_cloud.hpp"
#include "mesh/sub_mesh.hpp"
#include "mesh/triangle_geometry.hpp"
#include "terrain/detail/breaklines.hpp"
#include "terrain/detail/cloud_input.hpp"
#include "terrain/detail/cracks.hpp"
#include "terrain/detail/gdal_raster.hpp"
#include "terrain/detail/grid_holes.hpp"
#include "terrain/detail/layers.hpp"
#include "terrain/detail/resampling.hpp"
#include "terrain/detail/spike_groups.hpp"
#include "terrain/detail/spikes.hpp"
#include "terrain/detail/surface_holes.hpp"
#include "terrain/detail/surface_repair.hpp"
#include "terrain/detail/thinning.hpp"
#include "terrain/detail/zone_polygons.hpp"
#include "terrain/detail/zone_source.hpp"
#include "terrain/terrain_file.hpp"
#include "terrain/terrain_ranges.hpp"

namespace clast {
namespace {

namespace fs = std::filesystem;
using terrain_detail::RawSurface;

// Beyond this, coordinates are moved to a local origin.
constexpr double kLargeCoordinate = 1e4;  // m
// Holes of a mesh up to so many median edges are filled unless told else.
constexpr double kMeshHole = 3.0;
// A ground smaller or larger than this is rather one in other units.
constexpr double kSmallGround = 2.0, kLargeGround = 1e5;  // m

// Heights beyond are none.
constexpr double kHighest = 12000.0;      // m
constexpr double kUsualNoData = -9999.0;  // m, deep under any slope

enum class Kind { kMesh, kRaster, kCloud, kTerrain };

Kind kind_of(const fs::path& path) {
  const std::string extension = extension_of(path);
  if (extension == ".h5" || extension == ".hdf5") return Kind::kTerrain;
  if (terrain_detail::is_raster(path)) return Kind::kRaster;
  const std::vector<std::string>& clouds = cloud_extensions();
  if (std::find(clouds.begin(), clouds.end(), extension) != clouds.end()) return Kind::kCloud;
  const std::vector<std::string>& meshes = readable_mesh_extensions();
  if (std::find(meshes.begin(), meshes.end(), extension) != meshes.end()) return Kind::kMesh;
  throw InputError(path.string() +
                   ": a ground is a mesh (stl, ply, obj, ...), a raster (tif, asc, "
                   "...), a cloud (las, xyz, txt, csv, pts, pcd) or a terrain file (h5), not \"" +
                   extension + "\"; other rasters become one by gdal_translate " +
                   path.filename().string() + " ground.tif");
}

Kind common_kind(const std::vector<fs::path>& files) {
  const Kind kind = kind_of(files.front());
  for (const fs::path& file : files) {
    if (kind_of(file) != kind) {
      throw InputError(files.front().string() + " and " + file.string() +
                       ": meshes, rasters and clouds can't be mixed in one ground; give one kind");
    }
  }
  if (files.size() > 1 && kind == Kind::kRaster) {
    throw InputError(
        files[1].string() +
        ": a ground is one raster; join the tiles first (gdalbuildvrt ground.vrt ...)");
  }
  if (files.size() > 1 && kind == Kind::kTerrain) {
    throw InputError(files[1].string() + ": a ground is one terrain file; make one of all surveys");
  }
  return kind;
}

RawSurface read_meshes(const TerrainOptions& options) {
  RawSurface surface;
  for (std::size_t i = 0; i < options.surface.size(); ++i) {
    TriangleMesh mesh = read_mesh(options.surface[i]);
    surface.source.insert(surface.source.end(), mesh.triangles.size(),
                          static_cast<std::uint16_t>(i));
    surface.mesh = merged(std::move(surface.mesh), mesh);
  }
  if (options.up == "y") {
    for (Vec3& vertex : surface.mesh.vertices) vertex = terrain_detail::turned_z_up(vertex);
  }
  return surface;
}

RawSurface surface_of(const terrain_detail::HeightGrid& grid, const fs::path& path) {
  RawSurface surface;
  surface.mesh = terrain_detail::grid_surface(grid, path);
  surface.source.assign(surface.mesh.triangles.size(), 0);
  surface.cell = grid.step.minCoeff();
  const auto empty = std::count_if(grid.heights.begin(), grid.heights.end(),
                                   [](double height) { return !std::isfinite(height); });
  if (empty > 0) {
    surface.notes.push_back(path.string() + ": " + std::to_string(empty) + " of " +
                            std::to_string(grid.heights.size()) +
                            " cells have no height; the ground is left out there");
  }
  return surface;
}

std::string cells_of(double size) { return "cells of " + with_digits(size, 6) + " m"; }

/// Numbers that stand for "no height" in a file that does not say so make pits without a bottom.
void check_heights(const terrain_detail::HeightGrid& grid, const fs::path& path) {
  for (std::size_t i = 0; i < grid.heights.size(); ++i) {
    const double height = grid.heights[i];
    if (!std::isfinite(height) || (std::abs(height) <= kHighest && height != kUsualNoData)) {
      continue;
    }
    const Vec2 centre = grid.centre(i % grid.columns, i / grid.columns);
    const std::string number = with_digits(height, 9);
    throw InputError(path.string() + ": the height at " +
                     terrain_detail::place({centre.x(), centre.y(), height}) +
                     " m is none on earth. If " + number +
                     " stands for no data, say so first: gdal_translate -a_nodata " + number + " " +
                     path.filename().string() + " ground.tif");
  }
}

RawSurface read_one_raster(const TerrainOptions& options) {
  const fs::path& path = options.surface.front();
  terrain_detail::Raster raster = terrain_detail::read_raster(path);
  check_heights(raster.grid, path);
  std::vector<std::string> notes;
  if (options.resolution) {
    const terrain_detail::HeightGrid& grid = raster.grid;
    const double own = grid.step.maxCoeff();
    if (*options.resolution < own * (1.0 - 1e-9)) {
      throw InputError(path.string() + ": resolution = " + with_digits(*options.resolution, 6) +
                       " m is finer than the raster, which has " + cells_of(own) +
                       "; leave it out");
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
    raster.grid = terrain_detail::binned(points, *options.resolution, path);
    notes.push_back(path.string() + ": made coarser, means over " + cells_of(*options.resolution));
  } else if (std::none_of(raster.grid.heights.begin(), raster.grid.heights.end(),
                          [](double height) { return std::isfinite(height); })) {
    throw InputError(path.string() +
                     ": holds no heights, only nodata; check which value stands for no data");
  }
  if (options.fill) {
    const terrain_detail::HolesFilled filled =
        terrain_detail::fill_holes(raster.grid, *options.fill);
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
  terrain_detail::CloudGrid cloud = terrain_detail::cloud_grid(options);
  RawSurface surface = surface_of(cloud.grid, options.surface.front());
  surface.crs = std::move(cloud.crs);
  surface.notes.insert(surface.notes.begin(), cloud.notes.begin(), cloud.notes.end());
  return surface;
}

void mend(RawSurface& raw, const std::vector<std::string>& files,
          const std::vector<std::uint16_t>& zone_of_file, const TerrainOptions& options,
          TerrainReport& report) {
  terrain_detail::weld(raw, report);
  terrain_detail::drop_useless_triangles(raw, files, zone_of_file, report);
  terrain_detail::level_spike_groups(raw.mesh, options.spike_steepness, options.crack, report);
  terrain_detail::close_cracks(raw, options.crack, report);
  drop_unused_vertices(raw.mesh);
  terrain_detail::orient_upwards(raw, report);
  terrain_detail::drop_double_ground(raw, options.crack, report);
  terrain_detail::fill_surface_holes(raw, options.fill.value_or(kMeshHole * median_edge(raw.mesh)),
                                     options.crack, report);
  terrain_detail::note_gaps(raw, median_edge(raw.mesh), report);
  terrain_detail::note_slivers(raw, report);
}

/// Zone of every surface file, and the names in order of first appearance.
std::vector<std::uint16_t> zones_of_files(const TerrainOptions& options, Kind kind,
                                          bool assigned_later, std::vector<std::string>& names) {
  const std::size_t files = options.surface.size();
  if (options.zones.empty() || assigned_later) {
    if (!assigned_later) names = {"ground"};
    return std::vector<std::uint16_t>(files, 0);
  }
  if (options.zones.size() != files) {
    throw InputError(
        "zones: " + std::to_string(options.zones.size()) + " names for " + std::to_string(files) +
        " surface files; give one for each, one zone raster or polygon file, or rules");
  }
  if (kind == Kind::kCloud && files > 1) {
    throw InputError(
        "zones: several clouds make one grid, so a name for each can't be kept; give "
        "a zone raster or polygons");
  }
  std::vector<std::uint16_t> zone_of_file;
  for (const std::string& name : options.zones) {
    std::error_code code;
    if (fs::exists(name, code) && fs::path(name).has_extension()) {
      throw InputError(
          "zones: " + name +
          " is a file, but not of zones: those are rasters (tif, asc, ...) or polygons "
          "in geojson, gpkg or shp; convert it (ogr2ogr zones.gpkg " +
          fs::path(name).filename().string() + ")");
    }
    const auto known = std::find(names.begin(), names.end(), name);
    zone_of_file.push_back(static_cast<std::uint16_t>(known - names.begin()));
    if (known == names.end()) names.push_back(name);
  }
  return zone_of_file;
}

void move_to_local_origin(Terrain& terrain) {
  const Bounds box = bounds(terrain.surface);
  const Vec3 largest = box.low.cwiseAbs().cwiseMax(box.high.cwiseAbs());
  Vec3& origin = terrain.frame.origin;
  const Vec3 centre = (box.low + box.high) / 2.0;
  if (largest.head<2>().maxCoeff() > kLargeCoordinate) {
    origin.head<2>() = centre.head<2>().array().round();
  }
  if (largest.z() > kLargeCoordinate) origin.z() = std::round(centre.z());
  for (Vec3& vertex : terrain.surface.vertices) vertex = terrain.frame.local(vertex);
}

void note_doubts(Terrain& terrain) {
  std::vector<std::string>& notes = terrain.report.notes;
  const Bounds box = bounds(terrain.surface);
  const double extent = (box.high - box.low).head<2>().maxCoeff();
  if (extent < kSmallGround || extent > kLargeGround) {
    notes.push_back("the ground is " + with_digits(extent, 6) +
                    " m across; are its coordinates in metres?");
  }
  if (box.high.z() - box.low.z() > 3.0 * extent) {
    notes.push_back("the ground is " + with_digits(box.high.z() - box.low.z(), 6) + " m high and " +
                    with_digits(extent, 6) + " m across; is z its upward axis?");
  }
  std::size_t overhangs = 0;
  for (const auto& [a, b, c] : terrain.surface.triangles) {
    const std::vector<Vec3>& v = terrain.surface.vertices;
    const Vec3 ab = v[b] - v[a], ac = v[c] - v[a];
    if (ab.x() * ac.y() - ab.y() * ac.x() < 0.0) ++overhangs;
  }
  if (overhangs == 0) return;
  std::string note = std::to_string(overhangs) + " of " +
                     std::to_string(terrain.surface.triangles.size()) + " triangles overhang";
  // Ground seldom does; a ground that lies on its side always.
  if (overhangs * 10 > terrain.surface.triangles.size()) note += "; is z its upward axis?";
  notes.push_back(note);
}

void check_files(const TerrainOptions& options, const std::optional<ZoneFile>& zones) {
  std::vector<fs::path> files = options.surface;
  if (zones) files.push_back(zones->path);
  files.insert(files.end(), options.breaklines.begin(), options.breaklines.end());
  for (const fs::path& file : files) check_input_file(file);
}

}  // namespace

void TerrainOptions::check() const {
  if (surface.empty()) throw InputError("surface: no file; name at least one");
  if (surface.size() > 65535) {
    throw InputError("surface: " + std::to_string(surface.size()) +
                     " files; 65,535 at most, join some");
  }
  if (up != "z" && up != "y") throw InputError("up = \"" + up + "\"; must be \"z\" or \"y\"");
  const auto check_range = [](const char* field, const std::optional<double>& value,
                              const NumberRange& range) {
    if (!value || range.holds(*value)) return;
    throw InputError(std::string(field) + " = " + with_digits(*value, 6) + ": must be " +
                     range.words());
  };
  check_range("resolution", resolution, kCellSize);
  check_range("percentile", percentile, kPercentile);
  check_range("outliers", outliers, kOutlierDistance);
  check_range("crack", crack, kCrackWidth);
  check_range("spike_steepness", spike_steepness, kSpikeSteepness);
  check_range("tolerance", tolerance, kSurfaceTolerance);
  check_range("fill", fill, kHoleWidth);
  if (smoothing < 0 || smoothing > kMostSmoothing) {
    throw InputError("smoothing = " + std::to_string(smoothing) + ": must be from 0 to " +
                     std::to_string(kMostSmoothing) + " rounds");
  }
  for (const std::string& zone : zones) {
    if (zone.empty()) throw InputError("zones: an empty name; every zone needs one");
  }
}

Terrain read_terrain(const TerrainOptions& options) {
  options.check();
  const std::optional<ZoneFile> zones = zone_file(options.zones);
  const bool rules = are_zone_rules(options.zones);
  if (options.cut_zones && !(zones && terrain_detail::is_polygon_file(zones->path))) {
    throw InputError(
        "cut_zones: only the borders of polygons can be cut into the ground; give a "
        "polygon file as zones");
  }
  check_files(options, zones);
  const Kind kind = common_kind(options.surface);
  if (options.up == "y" && (kind == Kind::kRaster || kind == Kind::kTerrain)) {
    throw InputError(options.surface.front().string() +
                     ": rasters and terrain files are z up; leave out up = \"y\"");
  }
  if ((options.percentile || options.outliers) && kind != Kind::kCloud) {
    throw InputError(options.surface.front().string() +
                     ": percentile and outliers are for clouds; leave them out");
  }
  if (!options.breaklines.empty() && (kind == Kind::kMesh || kind == Kind::kTerrain)) {
    throw InputError(options.surface.front().string() +
                     ": breaklines are for rasters and clouds; a mesh has its edges already");
  }
  if (options.resolution && kind == Kind::kTerrain) {
    throw InputError(options.surface.front().string() +
                     ": a terrain file is checked and mended already; leave out resolution, or "
                     "start from the survey");
  }
  std::vector<std::string> digests;
  const auto digest = [](const fs::path& file) {
    return file.string() + " " + sha256_of_file(file);
  };
  for (const fs::path& file : options.surface) digests.push_back(digest(file));
  if (zones) digests.push_back(digest(zones->path));
  for (const fs::path& file : options.breaklines) digests.push_back(digest(file));
  if (kind == Kind::kTerrain) {
    if (options.tolerance || options.smoothing > 0 || options.fill) {
      throw InputError(options.surface.front().string() +
                       ": a terrain file is checked and mended already; leave out fill, smoothing "
                       "and tolerance, or start from the survey");
    }
    if (!options.zones.empty()) {
      throw InputError(options.surface.front().string() +
                       ": a terrain file has its zones already; leave zones out");
    }
    Terrain terrain = read_terrain_file(options.surface.front());
    terrain.sources.insert(terrain.sources.begin(), digests.front());
    return terrain;
  }

  Terrain terrain;
  const std::vector<std::uint16_t> zone_of_file =
      zones_of_files(options, kind, zones || rules, terrain.zone_names);
  RawSurface raw = kind == Kind::kMesh     ? read_meshes(options)
                   : kind == Kind::kRaster ? read_one_raster(options)
                                           : read_clouds(options);
  terrain.sources = std::move(digests);
  terrain.report.notes = std::move(raw.notes);
  terrain.report.triangles_read = raw.mesh.triangles.size();
  if (kind == Kind::kMesh) {
    std::vector<std::string> files;
    for (const fs::path& file : options.surface) files.push_back(file.string());
    mend(raw, files, zone_of_file, options, terrain.report);
  } else {
    terrain_detail::level_spike_groups(raw.mesh, options.spike_steepness, 0.0, terrain.report);
    terrain_detail::orient_upwards(raw, terrain.report);
  }
  terrain_detail::level_spikes(raw, options.spike_steepness, terrain.report);
  if (options.resolution && kind == Kind::kMesh) {
    raw = terrain_detail::resampled(raw, *options.resolution, options.surface.front(),
                                    terrain.report);
  }
  terrain_detail::smooth(raw.mesh, options.smoothing, terrain.report);
  if (!options.breaklines.empty()) {
    std::vector<terrain_detail::MapLine> lines;
    for (const fs::path& file : options.breaklines) {
      const std::vector<terrain_detail::MapLine> more =
          terrain_detail::read_map_lines(file, raw.crs);
      lines.insert(lines.end(), more.begin(), more.end());
    }
    terrain_detail::add_breaklines(raw, lines, raw.cell, terrain.report);
  }
  if (options.tolerance) terrain_detail::thin(raw, *options.tolerance, terrain.report);
  terrain.surface = std::move(raw.mesh);
  terrain.frame.crs = raw.crs;
  move_to_local_origin(terrain);
  if (zones) {
    terrain_detail::assign_zones(terrain, *zones, options.cut_zones);
  } else if (rules) {
    terrain_detail::assign_zones(terrain, options.zones);
  } else {
    for (const std::uint16_t file : raw.source) terrain.zone.push_back(zone_of_file[file]);
  }
  note_doubts(terrain);
  return terrain;
}

}  // namespace clast
