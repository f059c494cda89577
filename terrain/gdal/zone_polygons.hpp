#pragma once
/// Polygons with zone names through GDAL's vector drivers, with no GDAL type in sight.
#include <filesystem>
#include <string>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace clast::terrain_detail {

/// A zone polygon with holes: a point is inside when a ray from it crosses the rings an odd number
/// of times. A point on an edge shared by two polygons is in exactly one of them.
struct ZonePolygon {
  std::string zone;
  std::vector<std::vector<Vec2>> rings;  ///< on the map, m; holes run clockwise, outlines do not
  Vec2 low = Vec2::Zero();
  Vec2 high = Vec2::Zero();

  bool contains(const Vec2& point) const;
};

/// Reads GeoJSON, GeoPackage or Shapefile polygons with a text or number property "zone", and
/// reprojects them when both sides name a coordinate system and they differ.
/// @param crs  of the terrain; empty when unknown: coordinates are then taken as they are
/// @throws InputError  unreadable, no property "zone", something that is not a polygon, one that
///                     crosses itself, or two of different zones that overlap by more than a strip
///                     of 1 cm, which is what digitising by hand leaves
std::vector<ZonePolygon> read_zone_polygons(const std::filesystem::path& path,
                                            const std::string& crs);

/// The polygons of a file, whatever properties they have and whether they overlap or not; their
/// zone is empty.
/// @param crs  of the terrain, as above
/// @throws InputError  unreadable, something that is not a polygon, or one that crosses itself
std::vector<ZonePolygon> read_outline_polygons(const std::filesystem::path& path, const std::string& crs);

bool is_polygon_file(const std::filesystem::path& path);

}  // namespace clast::terrain_detail
