#pragma once
/// Values on square cells of the map as a GeoTIFF, through GDAL.
#include <cstddef>
#include <filesystem>
#include <span>
#include <string>

#include "core/files/output_file.hpp"
#include "core/types.hpp"

namespace clast::terrain_detail {

/// One band, north up.
struct GeoTiffBand {
  std::size_t columns = 0;
  std::size_t rows = 0;
  Vec2 corner = Vec2::Zero();     ///< north-west corner on the map, m
  double cell = 1.0;              ///< width of a cell, m
  std::span<const float> values;  ///< row by row from the north; NaN: none
  std::string meaning = {};       ///< its description in the file, with the unit
};

/// Writes 32-bit floats, nodata -9999, tiled and compressed.
/// @param crs  map system, "EPSG:2154" or WKT; where it is empty or unknown the file gets a local
///             system in metres, since coordinates without any are read as degrees
/// @throws InputError  GDAL can't write there; or as `OutputFile`
void write_geotiff(const std::filesystem::path& path, const GeoTiffBand& band,
                   const std::string& crs, const OverwritePolicy& rules = {});

}  // namespace clast::terrain_detail
