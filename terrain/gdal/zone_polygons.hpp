#pragma once
/// Reading of zone polygons with GDAL, without GDAL types in the interface.
#include <filesystem>
#include <string>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace clast::terrain_detail {

/// Zone polygon with holes. Inside and outside follow the even-odd rule. A point on an edge that
/// two polygons share is inside exactly one of them.
struct ZonePolygon {
  std::string zone;
  std::vector<std::vector<Vec2>>
      rings;  ///< map coordinates, m; outlines counter-clockwise, holes clockwise
  Vec2 low = Vec2::Zero();
  Vec2 high = Vec2::Zero();

  bool contains(const Vec2& point) const;
};

/// Reads GeoJSON, GeoPackage or Shapefile polygons with a text or number property "zone". They are
/// transformed to the terrain's coordinate system if both systems are known.
/// @param crs  coordinate system of the terrain; if empty, coordinates are used unchanged
/// @throws InputError  if the file cannot be read, lacks the property "zone", or has other
///                     geometries or self-intersecting polygons, or if polygons of different zones
///                     overlap by more than a strip of 1 cm, a usual digitising error
std::vector<ZonePolygon> read_zone_polygons(const std::filesystem::path& path,
                                            const std::string& crs);

/// Reads all polygons of a file. They need no property "zone" and may overlap.
/// @param crs  coordinate system of the terrain, as above
/// @throws InputError  if the file cannot be read, or has other geometries or self-intersecting
///                     polygons
std::vector<ZonePolygon> read_outline_polygons(const std::filesystem::path& path,
                                               const std::string& crs);

bool is_polygon_file(const std::filesystem::path& path);

}  // namespace clast::terrain_detail
