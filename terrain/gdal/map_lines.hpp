#pragma once
/// Reading of lines with GDAL, without GDAL types in the interface.
#include <filesystem>
#include <string>
#include <vector>

#include "core/types.hpp"

namespace clast::terrain_detail {

struct MapLine {
  std::vector<Vec3> points;  ///< map coordinates, m; z is 0 without heights
  bool has_heights = false;
  std::string name;  ///< for messages: "lines.geojson: feature 3"
};

/// Reads GeoJSON, GeoPackage or Shapefile lines, transformed to the terrain's system.
/// @param crs  of the terrain; empty if unknown
/// @throws InputError  if the file cannot be read, is empty, or has other geometries
std::vector<MapLine> read_map_lines(const std::filesystem::path& path, const std::string& crs);

}  // namespace clast::terrain_detail
