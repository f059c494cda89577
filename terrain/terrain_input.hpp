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
  /// .xyz, .txt, .csv, .pts, .pcd), or one terrain file (.h5).
  std::vector<std::filesystem::path> surface = {};
  /// One name per mesh, a zone raster, or a file of polygons (GeoJSON, GeoPackage, Shapefile) with
  /// property "zone". Class numbers of a raster are the names, or are mapped by
  /// "zones.asc:1=blue,2=gray". Or rules, the first match applies: "rock=slope>60",
  /// "scree=height<1450&slope>=30", "soil=else". Empty: one zone, "ground".
  std::vector<std::string> zones = {};  ///< as in TerrainOptions
  /// Up axis of meshes and clouds: "z"; "y", which rotates (x, y, z) to (x, -z, y); or "auto", y
  /// for glTF files and z for others.
  std::string up = "auto";
  /// Columns x, y and z of text clouds, by name or 1-based number; empty: by the heading.
  std::vector<std::string> columns = {};
  /// Cell size, m: of the grid of clouds (default: about four points per cell), of a coarsened
  /// raster, or of the grid to which a mesh without walls and overhangs is resampled.
  std::optional<double> resolution = {};
  /// Height of a cloud's cell: this percentile of its points, 0 the lowest, 100 the highest; empty:
  /// their mean.
  std::optional<double> percentile = {};
  /// Points of a cloud farther than this from the median of the surrounding ground (5 x 5 cells)
  /// are outliers, m. Must exceed the relief within a cell; empty: no outliers.
  std::optional<double> outliers = {};
  /// Holes up to this length and width are filled, m. Empty: three cells for clouds, three median
  /// edges for meshes, none for rasters.
  std::optional<double> fill = {};
  /// Cracks between mesh tiles are closed up to this width, m; 0: none.
  double crack = 0.01;
  /// Single vertices farther from the plane through their neighbours than this multiple of their
  /// mean distance are levelled; 0: none.
  double spike_steepness = 3.0;
  /// Number of smoothing rounds, each halfway to the plane through the neighbours.
  int smoothing = 0;
  /// Vertical tolerance of simplification, m, valid everywhere on the surface. Overhangs are
  /// unchanged. Empty: no simplification.
  std::optional<double> tolerance = {};
  /// Files of lines with heights (GeoJSON, GeoPackage, Shapefile) that become edges of a raster or
  /// cloud surface.
  std::vector<std::filesystem::path> breaklines = {};
  /// Split triangles along polygon borders.
  bool cut_zones = false;

  void check() const;  ///< throws InputError naming the field and its value
};

/// Zone file: a raster of class numbers or polygons with property "zone".
struct ZoneFile {
  std::filesystem::path path;
  std::map<long, std::string> names = {};  ///< of class numbers; empty: the number is the name

  std::vector<std::string> option_texts() const;  ///< as in TerrainOptions
};

/// Parses `zones` as a zone file ("zones.asc", "zones.asc:1=blue,2=gray", polygons.geojson); empty
/// if they are plain names. A list split at commas is joined again.
/// @throws InputError  if a mapping is invalid
std::optional<ZoneFile> parse_zone_file(const std::vector<std::string>& zones);

/// Checks a zone name.
/// @throws InputError  if it is empty, or has "=" or a control character, which ground tables, zone
///                     lists and rules cannot represent
void check_zone_name(const std::string& name);

/// True if `zones` are rules by slope and height.
bool are_zone_rules(const std::vector<std::string>& zones);

/// Reads a terrain: rotates to z up, checks and repairs it, orients normals upwards, and assigns
/// zones. Meshes: vertices are welded, degenerate and duplicate triangles removed, cracks closed,
/// holes filled. Rasters: cell centres are joined by two triangles per cell, none at nodata. Clouds
/// are streamed into a grid. Repairs are reported with count and position. A triangle has the zone
/// that covers most of its plan area.
/// @throws InputError  if a file cannot be read or a zone source does not fit
/// @throws GeometryError  if the surface cannot be repaired (non-manifold, non-orientable,
///                        duplicate ground), or triangles have no zone, with a position
Terrain read_terrain(const TerrainOptions& options);

/// Reads the vertices of lines of a GeoJSON, GeoPackage or Shapefile, in the map system of the
/// terrain, m.
/// @throws InputError  if the file cannot be read, is empty, or has other geometries
std::vector<std::vector<Vec2>> read_barrier_lines(const std::filesystem::path& path,
                                                  const Terrain& terrain);

}  // namespace clast
