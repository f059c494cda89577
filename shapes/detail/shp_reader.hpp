#pragma once
/// Parser of .shp files.
#include <string_view>
#include <vector>

#include "shapes/shp_file.hpp"

namespace clast::shapes_detail {

/// Magic number of ESRI shapefiles, which share the extension.
inline constexpr std::string_view kEsriShapefileMagic{"\0\0\x27\x0a", 4};

/// Parses the shapes of a .shp file.
/// @throws InputError  as `read_shp`; the message gives line and shape
std::vector<ShpShape> parse_shp(std::string_view content);

}  // namespace clast::shapes_detail
