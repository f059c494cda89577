#pragma once
/// Where the ground zone of every triangle comes from.
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "terrain/terrain.hpp"

namespace clast::detail {

/// A raster of class numbers or a file of polygons with a property "zone".
struct ZoneFile {
  std::filesystem::path path;
  std::map<long, std::string> names;  ///< of class numbers; empty: the number is the name
};

/// `zones` as a zone file ("zones.asc", "zones.asc:1=blue,2=gray", polygons.geojson), or none when
/// they are plain names. A list cut at its commas is put together again.
/// @throws InputError  a mapping that can't be read
std::optional<ZoneFile> zone_file(const std::vector<std::string>& zones);

/// Gives every triangle the zone in which its centroid lies, seen from above.
/// @param terrain  everything but zones; `zone` and `zone_names` are filled in, those used, in
///                 order of class number or of first appearance in the file
/// @throws InputError     a source that can't be read or does not fit; overlapping polygons with
///                        different zones
/// @throws GeometryError  ground without a zone: its area and a place
void assign_zones(Terrain& terrain, const ZoneFile& source);

}  // namespace clast::detail
