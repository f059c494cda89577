#pragma once
/// Surveyors' files to a checked terrain.
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "terrain/terrain.hpp"

namespace clast {

/// How surface files are read and zoned. File paths are used as given.
struct TerrainOptions {
  /// Meshes (.stl, .ply, .obj, ...), one raster (.tif, .asc, ...), clouds (.las, .xyz, .txt, .csv,
  /// .pts, .pcd), or one terrain file (.h5).
  std::vector<std::filesystem::path> surface = {};
  /// A name per mesh, or one zone raster, or one file of polygons (GeoJSON, GeoPackage, Shapefile)
  /// with a property "zone". A raster holds class numbers; they are the names, or get them by
  /// "zones.asc:1=blue,2=gray". Or rules, of which the first that holds decides: "rock=slope>60",
  /// "scree=height<1450&slope>=30", "soil=else". Empty: one zone, "ground".
  std::vector<std::string> zones = {};
  /// Of meshes and clouds: "z"; "y", which turns (x, y, z) to (x, -z, y); or "auto", y of glTF
  /// files and z of all others.
  std::string up = "auto";
  /// Of text clouds: three names or numbers from 1, those of the columns x, y and z; empty: the
  /// heading of the file names them.
  std::vector<std::string> columns = {};
  /// Cell size, m: of the grid that clouds are binned to (default: about four points per cell), of
  /// a raster that is to be made coarser, and of the grid that a mesh without walls and overhangs
  /// is to be made into.
  std::optional<double> resolution = {};
  /// Height of a cloud's cell: this percentile of the points in it, 0 the lowest, 100 the highest;
  /// their mean when absent.
  std::optional<double> percentile = {};
  /// Points of a cloud farther than this above or below the median of the ground around (5 x 5
  /// cells) are left out, m. Must be more than the relief within a cell; absent: all count.
  std::optional<double> outliers = {};
  /// Holes up to this length and width are filled, m; wider ones stay open. Absent: of clouds
  /// three cells, of meshes three median edges, of rasters none, whose gaps are meant.
  std::optional<double> fill = {};
  /// Cracks between the tiles of a mesh are closed up to this width, m; 0: none.
  double crack = 0.01;
  /// A single vertex of any ground that is off the plane through its neighbours by more than this
  /// many times their mean distance is levelled; 0: none.
  double spike_steepness = 3.0;
  /// Rounds of smoothing, each halfway to the plane through the neighbours; 0: none.
  int smoothing = 0;
  /// Vertices of any ground are left out where the surface keeps within this height of what it was,
  /// m, everywhere and not only at its vertices. Overhangs stay as they are.
  std::optional<double> tolerance = {};
  /// Files of lines with heights (GeoJSON, GeoPackage, Shapefile) that become edges of the surface
  /// of a raster or cloud.
  std::vector<std::filesystem::path> breaklines = {};
  /// Polygon borders are cut into the triangles, so that zones end where the polygons do.
  bool cut_zones = false;

  void check() const;  ///< throws InputError naming the field and its value
};

/// A raster of class numbers or a file of polygons with a property "zone".
struct ZoneFile {
  std::filesystem::path path;
  std::map<long, std::string> names = {};  ///< of class numbers; empty: the number is the name

  std::vector<std::string> option_texts() const;  ///< as in TerrainOptions
};

/// `zones` as a zone file ("zones.asc", "zones.asc:1=blue,2=gray", polygons.geojson), or none when
/// they are plain names. A list cut at its commas is put together again.
/// @throws InputError  a mapping that can't be read
std::optional<ZoneFile> parse_zone_file(const std::vector<std::string>& zones);

/// Whether a ground zone can be called so: ground tables, zone lists and rules are written with
/// "=", and a name is one line.
/// @throws InputError  a name that is empty or has "=" or a control character in it
void check_zone_name(const std::string& name);

/// True when `zones` are rules by slope and height and not names or a file.
bool are_zone_rules(const std::vector<std::string>& zones);

/// Reads, turns z up, checks and repairs, turns normals out of the ground, and assigns zones.
/// Meshes: vertices are welded, degenerate and duplicate triangles dropped, cracks closed, holes
/// filled. Rasters: heights are at cell centres; the surface joins the centres with two triangles
/// per cell, none at nodata. Clouds are streamed into a grid of cells. Every repair is in the
/// report, with a count and a place. A triangle has the zone that covers most of its plan area.
/// @throws InputError     a file that can't be read or a zone source that does not fit; names it
/// @throws GeometryError  a surface that can't be repaired (edges of three triangles, one side
/// only,
///                        ground that lies double), or triangles without a zone, with a place
Terrain read_terrain(const TerrainOptions& options);

/// Corners of the lines of a GeoJSON, GeoPackage or Shapefile, in the map system of the terrain, m.
/// @throws InputError  unreadable, empty, or something that is not a line
std::vector<std::vector<Vec2>> read_barrier_lines(const std::filesystem::path& path,
                                                  const Terrain& terrain);

}  // namespace clast
