#pragma once
/// The text of a .shp file.
#include <string_view>
#include <vector>

#include "shapes/shp_file.hpp"

namespace clast::shapes_detail {

/// First bytes of an ESRI shapefile, which has the same extension.
inline constexpr std::string_view kEsriShapefileMagic{"\0\0\x27\x0a", 4};

/// @throws InputError  with line and shape, as `read_shp` says
std::vector<ShpShape> parse_shp(std::string_view content);

}  // namespace clast::shapes_detail
