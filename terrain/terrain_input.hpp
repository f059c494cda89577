#pragma once
/// Surveyors' files to a checked terrain.
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "terrain/terrain.hpp"

namespace clast {

/// How surface files are read and zoned. File paths are used as given.
struct TerrainOptions {
  std::vector<std::filesystem::path> surface;  ///< meshes, one raster, clouds (.xyz), or one terrain.h5
  /// A name per surface file, or one zone raster, or one GeoJSON of polygons with a property "zone".
  /// Empty: one zone, "ground".
  std::vector<std::string> zones;
  std::string up = "z";                        ///< "z" or "y"; "y" turns (x, y, z) to (x, -z, y)
  std::optional<double> resolution;            ///< cell size for clouds and resampled rasters, m

  void check() const;  ///< throws InputError naming the field and its value
};

/// Reads, turns z up, welds, drops degenerate and duplicate triangles, turns normals out of the
/// ground, and assigns zones.
/// Rasters: heights are at cell centres; the surface joins the centres with two triangles per cell,
/// none at nodata. Clouds are binned to the mean height per cell.
/// @throws InputError     a file that can't be read or a zone source that does not fit; names it
/// @throws GeometryError  a surface that can't be mended, or triangles without a zone, with a place
Terrain read_terrain(const TerrainOptions& options);

}  // namespace clast
