#pragma once
/// Lines from files through GDAL's vector drivers, with no GDAL type in sight.
#include <filesystem>
#include <string>
#include <vector>

#include "core/types.hpp"

namespace clast::terrain_detail {

struct MapLine {
  std::vector<Vec3> points;  ///< on the map, m; z 0 when there are no heights
  bool has_heights = false;
  std::string name;  ///< "lines.geojson: feature 3", for messages
};

/// Reads GeoJSON, GeoPackage or Shapefile lines, and reprojects them as zone polygons are.
/// @param crs  of the terrain; empty when unknown
/// @throws InputError  unreadable, empty, or something that is not a line
std::vector<MapLine> read_map_lines(const std::filesystem::path& path, const std::string& crs);

}  // namespace clast::terrain_detail
