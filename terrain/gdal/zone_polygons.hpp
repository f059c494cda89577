#pragma once
/// Reading of zone polygons with GDAL, without GDAL types in the interface.
#include <filesystem>
#include <string>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace clast::terrain_detail {

/// Zone polygon with holes, by the even-odd rule. A point on an edge shared by two polygons is
/// inside exactly one of them.
struct ZonePolygon {
  std::string zone;
  std::vector<std::vector<Vec2>>
      rings;  ///< map coordinates, m; outlines counter-clockwise, holes clockwise
  Vec2 low = Vec2::Zero();
  Vec2 high = Vec2::Zero();

  bool contains(const Vec2& point) const;
};

/// Reads GeoJSON, GeoPackage or Shapefile polygons with a text or number property "zone",
/// transformed to the terrain's system if both are known.
/// @param crs  of the terrain; empty if unknown: coordinates are then used unchanged
/// @throws InputError  if the file cannot be read, lacks the property "zone", has other geometries
///                     or self-intersecting polygons, or polygons of different zones overlap by
///                     more than a strip of 1 cm (digitising error)
std::vector<ZonePolygon> read_zone_polygons(const std::filesystem::path& path,
                                            const std::string& crs);

/// Reads all polygons of a file without zones; overlaps are allowed.
/// @param crs  of the terrain, as above
/// @throws InputError  if the file cannot be read, or has other geometries or self-intersecting
///                     polygons
std::vector<ZonePolygon> read_outline_polygons(const std::filesystem::path& path,
                                               const std::string& crs);

bool is_polygon_file(const std::filesystem::path& path);

}  // namespace clast::terrain_detail
