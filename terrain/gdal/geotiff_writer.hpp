#pragma once
/// Writing of GeoTIFF files with GDAL.
#include <cstddef>
#include <filesystem>
#include <span>
#include <string>

#include "core/files/output_file.hpp"
#include "core/types.hpp"

namespace clast::terrain_detail {

/// Raster band of square cells, north up.
struct GeoTiffBand {
  std::size_t columns = 0;
  std::size_t rows = 0;
  Vec2 corner = Vec2::Zero();     ///< north-west corner, map coordinates, m
  double cell = 1.0;              ///< width of a cell, m
  std::span<const float> values;  ///< row-major from the north; NaN: no value
  std::string meaning = {};       ///< description in the file, with unit
};

/// Writes a tiled and compressed file of 32-bit floats, with nodata -9999.
/// @param crs  coordinate system, "EPSG:2154" or WKT; if empty or unknown, a local system in metres
///             is written, because other programs read coordinates without a system as degrees
/// @throws InputError  if GDAL cannot write the file; or as `OutputFile`
void write_geotiff(const std::filesystem::path& path, const GeoTiffBand& band,
                   const std::string& crs, const OverwritePolicy& rules = {});

}  // namespace clast::terrain_detail
