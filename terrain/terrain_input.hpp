#pragma once
/// Reading of survey files into a checked terrain.
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "terrain/terrain.hpp"

namespace clast {

/// Options for reading surface files and zones.
struct TerrainOptions {
  /// Surface files: meshes (.stl, .ply, .obj, ...), one raster (.tif, .asc, ...), clouds (.las,
  /// .laz, .xyz, .txt, .csv, .pts, .pcd), or one terrain file (.h5).
  std::vector<std::filesystem::path> surface = {};
  /// Ground zones in one of four forms. If empty, there is one zone, "ground".
  /// - One name per mesh.
  /// - A file of polygons (GeoJSON, GeoPackage, Shapefile) with the property "zone".
  /// - A raster of class numbers. They are the names unless "zones.asc:1=blue,2=gray" maps them.
  /// - Rules "rock=slope>60", "scree=height<1450&slope>=30", "soil=else". The first match applies.
  std::vector<std::string> zones = {};
  /// Up axis of meshes and clouds: "z"; "y", which rotates (x, y, z) to (x, -z, y); or "auto",
  /// which is y for glTF files and z for others.
  std::string up = "auto";
  /// Columns x, y and z of text clouds, by name or number from 1. If empty, the heading decides.
  std::vector<std::string> columns = {};
  /// Cell size, m. Clouds are gridded with it (default: about four points per cell), rasters are
  /// coarsened to it, and meshes without walls and overhangs are resampled to it.
  std::optional<double> resolution = {};
  /// Percentile of point heights (0 to 100) that becomes the height of a grid cell of a cloud. If
  /// empty, the mean height is used.
  std::optional<double> percentile = {};
  /// Limit for outliers of clouds, m. A point farther than this from the median height of the
  /// surrounding 5 x 5 cells is an outlier. The limit must exceed the relief within a cell. If
  /// empty, no point is an outlier.
  std::optional<double> outliers = {};
  /// Largest length and width of holes that are filled, m. If empty: three cells for clouds, three
  /// median edges for meshes; holes of rasters are not filled.
  std::optional<double> fill = {};
  /// Largest width of cracks between mesh tiles that are closed, m.
  double crack = 0.01;
  /// Vertices are levelled as spikes if their distance from the plane through their neighbours
  /// exceeds this multiple of the mean distance of the neighbours. If 0, none is levelled.
  double spike_steepness = 3.0;
  /// Number of smoothing rounds. Each moves vertices halfway to the plane through their neighbours.
  int smoothing = 0;
  /// Largest vertical distance between the simplified and the original surface, m. Overhangs are
  /// unchanged. If empty, the surface is not simplified.
  std::optional<double> tolerance = {};
  /// Files of lines with heights (GeoJSON, GeoPackage, Shapefile) that become edges of a raster or
  /// cloud surface.
  std::vector<std::filesystem::path> breaklines = {};
  /// If true, triangles are split along polygon borders.
  bool cut_zones = false;

  void check() const;  ///< throws InputError naming the field and its value
};

/// Zone file: a raster of class numbers or polygons with property "zone".
struct ZoneFile {
  std::filesystem::path path;
  std::map<long, std::string> names = {};  ///< by class number; if empty, the number is the name

  std::vector<std::string> zone_option_values() const;  ///< values of `TerrainOptions::zones`
};

/// Parses `zones` as a zone file ("zones.asc", "zones.asc:1=blue,2=gray", "polygons.geojson");
/// empty if they are plain names. A mapping that was split at its commas is joined again.
/// @throws InputError  if a mapping is invalid
std::optional<ZoneFile> parse_zone_file(const std::vector<std::string>& zones);

/// Checks a zone name.
/// @throws InputError  if it is empty, or if it contains "=" or a control character
void check_zone_name(const std::string& name);

/// True if `zones` are rules for slope and height.
bool are_zone_rules(const std::vector<std::string>& zones);

/// Reads a terrain, checks and repairs it, and assigns zones. The result is z up, with normals out
/// of the ground. Repairs are reported with count and position.
/// - Meshes: vertices are welded, invalid triangles removed, cracks closed and holes filled.
/// - Rasters: four adjacent cell centres with data are joined by two triangles.
/// - Clouds: points are streamed into a grid, which is triangulated like a raster.
/// @throws InputError  if a file cannot be read, or if a zone source does not fit the terrain
/// @throws GeometryError  if the surface cannot be repaired (non-manifold, non-orientable,
///                        duplicate ground), or if triangles have no zone; the message gives a
///                        position
Terrain read_terrain(const TerrainOptions& options);

/// Reads vertices of GeoJSON, GeoPackage or Shapefile lines, in the terrain's map coordinates, m.
/// @throws InputError  if the file cannot be read, is empty, or has geometries other than lines
std::vector<std::vector<Vec2>> read_barrier_lines(const std::filesystem::path& path,
                                                  const Terrain& terrain);

}  // namespace clast
