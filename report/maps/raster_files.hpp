#pragma once
/// Raster maps for QGIS and its like.
#include <filesystem>
#include <string>
#include <vector>

#include "study/compare/map_rasters.hpp"

namespace clast::report_detail {

/// One GeoTIFF per layer, FOLDER/NAME.tif: 32-bit floats, nodata -9999, tiled and compressed, with
/// the map system when there is one; beside it NAME.qml, with which QGIS shows it as the report's
/// map does.
/// @return the files; none without layers
/// @throws InputError  GDAL can't write there
std::vector<std::filesystem::path> write_rasters(const std::filesystem::path& folder,
                                                 const MapRasterSet& rasters, const std::string& crs);

}  // namespace clast::report_detail
