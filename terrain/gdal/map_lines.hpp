#pragma once
/// Reading of lines with GDAL, without GDAL types in the interface.
#include <filesystem>
#include <string>
#include <vector>

#include "core/types.hpp"

namespace clast::terrain_detail {

struct MapLine {
  std::vector<Vec3> points;  ///< map coordinates, m; z is 0 if the line has no heights
  bool has_heights = false;
  std::string name;  ///< for messages: "lines.geojson: feature 3"
};

/// Reads GeoJSON, GeoPackage or Shapefile lines and transforms them to the terrain's system.
/// @param crs  coordinate system of the terrain; empty if unknown
/// @throws InputError  if the file cannot be read, is empty, or has geometries other than lines
std::vector<MapLine> read_map_lines(const std::filesystem::path& path, const std::string& crs);

}  // namespace clast::terrain_detail
