#include "terrain/terrain_input.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "core/files/digest.hpp"
#include "core/files/input_file.hpp"
#include "core/files/up_axis.hpp"
#include "core/number_text.hpp"
#include "mesh/plan_geometry.hpp"
#include "mesh/sub_mesh.hpp"
#include "mesh/triangle_geometry.hpp"
#include "terrain/gdal/zone_polygons.hpp"
#include "terrain/input/resampling.hpp"
#include "terrain/input/surface_files.hpp"
#include "terrain/repair/breaklines.hpp"
#include "terrain/repair/cracks.hpp"
#include "terrain/repair/overlapping_ground.hpp"
#include "terrain/repair/simplification.hpp"
#include "terrain/repair/spike_groups.hpp"
#include "terrain/repair/spikes.hpp"
#include "terrain/repair/surface_holes.hpp"
#include "terrain/repair/surface_repair.hpp"
#include "terrain/terrain_file.hpp"
#include "terrain/terrain_ranges.hpp"
#include "terrain/zones/zone_source.hpp"

namespace clast {
namespace {

namespace fs = std::filesystem;
using terrain_detail::RawSurface;
using terrain_detail::SurfaceKind;

// Beyond this, coordinates are moved to a local origin.
constexpr double kLargeCoordinate = 1e4;  // m
// Holes of a mesh up to so many median edges are filled by default.
constexpr double kMeshHole = 3.0;
// A ground smaller or larger than this is rather one in other units.
constexpr double kSmallGround = 2.0, kLargeGround = 1e5;  // m

/// Joins the tiles of a mesh, and repairs what keeps it from being a ground.
void repair_tiles(RawSurface& raw, const std::vector<std::uint16_t>& zone_of_file,
                  const TerrainOptions& options, TerrainReport& report) {
  std::vector<std::string> files;
  for (const fs::path& file : options.surface) files.push_back(file.string());
  terrain_detail::weld_surface(raw, report);
  terrain_detail::remove_invalid_triangles(raw, files, zone_of_file, report);
  terrain_detail::level_spike_groups(raw.mesh, options.spike_steepness, options.crack, report);
  terrain_detail::close_cracks(raw, options.crack, report);
  remove_unused_vertices(raw.mesh);
  terrain_detail::orient_upwards(raw, report);
  terrain_detail::remove_overlapping_ground(raw, options.crack, report);
  if (raw.mesh.triangles.empty()) {
    throw GeometryError(files.front() + (files.size() > 1 ? " and the other surfaces" : "") +
                        ": none of " + std::to_string(report.triangles_read) +
                        " triangles remains as ground, because all are without area or duplicates; "
                        "export the surface again");
  }
  terrain_detail::fill_surface_holes(
      raw, options.fill.value_or(kMeshHole * median_edge_length(raw.mesh)), options.crack, report);
  terrain_detail::note_gaps(raw, median_edge_length(raw.mesh), report);
  terrain_detail::note_slivers(raw, report);
}

/// Zone of every surface file, and the names in order of first appearance.
std::vector<std::uint16_t> zones_of_files(const TerrainOptions& options, SurfaceKind kind,
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
  if (kind == SurfaceKind::kCloud && files > 1) {
    throw InputError(
        "zones: several clouds form one grid, so zones can't be named for each cloud; give a zone "
        "raster or polygons");
  }
  std::vector<std::uint16_t> zone_of_file;
  for (const std::string& name : options.zones) {
    std::error_code code;
    if (fs::exists(name, code) && fs::path(name).has_extension()) {
      throw InputError("zones: " + name +
                       " is not a file of zones, which are rasters (tif, asc, ...) or polygons "
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
  for (Vec3& vertex : terrain.surface.vertices) vertex = terrain.frame.to_local(vertex);
}

void note_doubts(Terrain& terrain) {
  std::vector<std::string>& notes = terrain.report.notes;
  const Bounds box = bounds(terrain.surface);
  const double extent = (box.high - box.low).head<2>().maxCoeff();
  if (extent < kSmallGround || extent > kLargeGround) {
    notes.push_back("the ground is " + format_significant(extent, 6) +
                    " m across: check that its coordinates are in metres");
  }
  if (box.high.z() - box.low.z() > 3.0 * extent) {
    notes.push_back("the ground is " + format_significant(box.high.z() - box.low.z(), 6) +
                    " m high and " + format_significant(extent, 6) +
                    " m across: check that z is its upward axis");
  }
  std::size_t overhangs = 0;
  for (const auto& [a, b, c] : terrain.surface.triangles) {
    const std::vector<Vec3>& v = terrain.surface.vertices;
    if (twice_area(v[a].head<2>(), v[b].head<2>(), v[c].head<2>()) < 0.0) ++overhangs;
  }
  if (overhangs == 0) return;
  std::string note = std::to_string(overhangs) + " of " +
                     std::to_string(terrain.surface.triangles.size()) + " triangles overhang";
  // Ground seldom does; a ground that lies on its side always.
  if (overhangs * 10 > terrain.surface.triangles.size())
    note += ": check that z is the upward axis";
  notes.push_back(note);
}

void check_files(const TerrainOptions& options, const std::optional<ZoneFile>& zones) {
  std::vector<fs::path> files = options.surface;
  if (zones) files.push_back(zones->path);
  files.insert(files.end(), options.breaklines.begin(), options.breaklines.end());
  for (const fs::path& file : files) check_input_file(file);
}

/// @throws InputError  an option that a surface of this kind has no use for
void check_suits(const TerrainOptions& options, SurfaceKind kind) {
  const bool mesh = kind == SurfaceKind::kMesh, terrain_file = kind == SurfaceKind::kTerrain;
  const auto refuse = [&](const char* why) {
    throw InputError(options.surface.front().string() + ": " + why);
  };
  if (options.up == "y" && (kind == SurfaceKind::kRaster || terrain_file)) {
    refuse("rasters and terrain files are z up; leave out up = \"y\"");
  }
  if ((options.percentile || options.outliers) && kind != SurfaceKind::kCloud) {
    refuse("percentile and outliers apply only to clouds; leave them out");
  }
  if (!options.columns.empty() && kind != SurfaceKind::kCloud) {
    refuse("columns apply only to clouds in text; leave them out");
  }
  if (!options.breaklines.empty() && (mesh || terrain_file)) {
    refuse("breaklines apply only to rasters and clouds; leave them out");
  }
  if (!terrain_file) return;
  if (options.resolution) {
    refuse(
        "a terrain file is already checked and repaired; leave out resolution, or start from the "
        "survey");
  }
  if (options.tolerance || options.smoothing > 0 || options.fill) {
    refuse(
        "a terrain file is already checked and repaired; leave out fill, smoothing and tolerance, "
        "or "
        "start from the survey");
  }
  if (!options.zones.empty()) refuse("a terrain file already has zones; leave zones out");
}

/// "path digest" of every file that is read.
std::vector<std::string> digests_of(const TerrainOptions& options,
                                    const std::optional<ZoneFile>& zones) {
  std::vector<std::string> digests;
  const auto add = [&](const fs::path& file) {
    digests.push_back(file.string() + " " + sha256_of_file(file));
  };
  for (const fs::path& file : options.surface) add(file);
  if (zones) add(zones->path);
  for (const fs::path& file : options.breaklines) add(file);
  return digests;
}

void add_breaklines(RawSurface& raw, const std::vector<fs::path>& files, TerrainReport& report) {
  if (files.empty()) return;
  std::vector<terrain_detail::MapLine> lines;
  for (const fs::path& file : files) {
    const std::vector<terrain_detail::MapLine> more = terrain_detail::read_map_lines(file, raw.crs);
    lines.insert(lines.end(), more.begin(), more.end());
  }
  terrain_detail::add_breaklines(raw, lines, raw.cell, report);
}

}  // namespace

void TerrainOptions::check() const {
  if (surface.empty()) throw InputError("surface: no file; name at least one");
  if (surface.size() > 65535) {
    throw InputError("surface: " + std::to_string(surface.size()) +
                     " files; the limit is 65,535, join some");
  }
  resolve_up_axis(up, {});
  const auto check_range = [](const char* field, const std::optional<double>& value,
                              const NumberRange& range) {
    if (!value || range.contains(*value)) return;
    throw InputError(std::string(field) + " = " + format_significant(*value, 6) + ": must be " +
                     range.describe());
  };
  check_range("resolution", resolution, kCellSizeRange);
  check_range("percentile", percentile, kPercentileRange);
  check_range("outliers", outliers, kOutlierDistanceRange);
  check_range("crack", crack, kCrackWidthRange);
  check_range("spike_steepness", spike_steepness, kSpikeSteepnessRange);
  check_range("tolerance", tolerance, kSurfaceToleranceRange);
  check_range("fill", fill, kHoleWidthRange);
  if (smoothing < 0 || smoothing > kMaxSmoothing) {
    throw InputError("smoothing = " + std::to_string(smoothing) + ": must be from 0 to " +
                     std::to_string(kMaxSmoothing) + " rounds");
  }
  for (const std::string& zone : zones) {
    if (zone.empty()) throw InputError("zones: an empty name; every zone needs one");
  }
}

Terrain read_terrain(const TerrainOptions& options) {
  options.check();
  const std::optional<ZoneFile> zones = parse_zone_file(options.zones);
  const bool rules = are_zone_rules(options.zones);
  if (options.cut_zones && !(zones && terrain_detail::is_polygon_file(zones->path))) {
    throw InputError(
        "cut_zones: only the borders of polygons can be cut into the ground; give a "
        "polygon file as zones");
  }
  check_files(options, zones);
  const SurfaceKind kind = terrain_detail::detect_surface_kind(options.surface);
  check_suits(options, kind);
  std::vector<std::string> digests = digests_of(options, zones);
  if (kind == SurfaceKind::kTerrain) {
    Terrain terrain = read_terrain_file(options.surface.front());
    terrain.sources.insert(terrain.sources.begin(), digests.front());
    return terrain;
  }

  Terrain terrain;
  const std::vector<std::uint16_t> zone_of_file =
      zones_of_files(options, kind, zones || rules, terrain.zone_names);
  RawSurface raw = terrain_detail::read_surface(options, kind);
  terrain.sources = std::move(digests);
  terrain.report.notes = std::move(raw.notes);
  terrain.report.triangles_read = raw.mesh.triangles.size();
  if (kind == SurfaceKind::kMesh) {
    repair_tiles(raw, zone_of_file, options, terrain.report);
  } else {
    terrain_detail::level_spike_groups(raw.mesh, options.spike_steepness, 0.0, terrain.report);
    terrain_detail::orient_upwards(raw, terrain.report);
  }
  terrain_detail::level_spikes(raw, options.spike_steepness, terrain.report);
  if (options.resolution && kind == SurfaceKind::kMesh) {
    raw = terrain_detail::resample_surface(raw, *options.resolution, options.surface.front(),
                                           terrain.report);
  }
  terrain_detail::smooth_surface(raw.mesh, options.smoothing, terrain.report);
  add_breaklines(raw, options.breaklines, terrain.report);
  if (options.tolerance) terrain_detail::simplify_surface(raw, *options.tolerance, terrain.report);
  terrain.surface = std::move(raw.mesh);
  terrain.frame.crs = raw.crs;
  move_to_local_origin(terrain);
  if (zones) {
    terrain_detail::assign_zones(terrain, *zones, options.cut_zones);
  } else if (rules) {
    terrain_detail::assign_zones(terrain, options.zones);
  } else {
    for (const std::uint16_t file : raw.source_file) terrain.zone.push_back(zone_of_file[file]);
  }
  note_doubts(terrain);
  return terrain;
}

std::vector<std::vector<Vec2>> read_barrier_lines(const fs::path& path, const Terrain& terrain) {
  std::vector<std::vector<Vec2>> lines;
  for (const terrain_detail::MapLine& line :
       terrain_detail::read_map_lines(path, terrain.frame.crs)) {
    lines.emplace_back();
    for (const Vec3& point : line.points) lines.back().push_back(point.head<2>());
  }
  return lines;
}

}  // namespace clast
