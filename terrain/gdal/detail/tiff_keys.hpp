#pragma once
/// GeoTIFF keys of a file. The reference system that GDAL derives from them hides contradictory
/// units.
#include <filesystem>

#include "mesh/geotiff_keys.hpp"

namespace clast::terrain_detail {

/// Reads the keys of the first image of a TIFF or BigTIFF file; those of other files are empty.
GeoTiffKeys read_geotiff_keys(const std::filesystem::path& path);

}  // namespace clast::terrain_detail
