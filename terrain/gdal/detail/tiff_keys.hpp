#pragma once
/// GeoTIFF keys of a file. Read directly, because GDAL's system hides contradictory units.
#include <filesystem>

#include "mesh/geotiff_keys.hpp"

namespace clast::terrain_detail {

/// Reads the keys of the first image of a TIFF or BigTIFF file; empty for other files.
GeoTiffKeys read_geotiff_keys(const std::filesystem::path& path);

}  // namespace clast::terrain_detail
