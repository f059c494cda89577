#pragma once
/// Raster maps for GIS programs.
#include <filesystem>
#include <string>
#include <vector>

#include "study/compare/map_rasters.hpp"

namespace clast::report_detail {

/// Writes each raster layer as GeoTIFF (32-bit floats, nodata -9999), with its QGIS style.
/// @return the written files; empty if there are no layers
/// @throws InputError  if GDAL cannot write a file
std::vector<std::filesystem::path> write_rasters(const std::filesystem::path& folder,
                                                 const MapRasterSet& rasters,
                                                 const std::string& crs);

}  // namespace clast::report_detail
