#pragma once
/// Raster maps for GIS programs.
#include <filesystem>
#include <string>
#include <vector>

#include "study/compare/map_rasters.hpp"

namespace clast::report_detail {

/// Writes one GeoTIFF per layer, FOLDER/NAME.tif (32-bit floats, nodata -9999, tiled, compressed,
/// with the CRS if known), and NAME.qml with the style of the report's map.
/// @return the files; empty without layers
/// @throws InputError  if GDAL cannot write a file
std::vector<std::filesystem::path> write_rasters(const std::filesystem::path& folder,
                                                 const MapRasterSet& rasters,
                                                 const std::string& crs);

}  // namespace clast::report_detail
