#pragma once
/// Reading of rasters with GDAL, without GDAL types in the interface.
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "terrain/raw_surface.hpp"

namespace clast::terrain_detail {

/// Raster band on a north-up grid: heights or class numbers.
struct Raster {
  HeightGrid grid;
  std::string crs;   ///< horizontal coordinate system, "EPSG:2154" or WKT; empty if unknown
  std::string unit;  ///< unit of the values declared by the band; empty if not declared
  std::optional<double> no_data;   ///< fill value declared by the band
  std::vector<std::string> notes;  ///< notes on its coordinate system
};

/// Reads a raster with one band. Files with rows from south to north are reversed.
/// @throws InputError  if the file is not a raster, has no georeference or several bands, is
///                     rotated or in degrees, has horizontal or vertical units other than metres,
///                     or if its projection distorts lengths
Raster read_raster(const std::filesystem::path& path);

/// Checks that the height unit is the metre or not declared.
/// @throws InputError  if another unit is declared
void check_height_unit(const std::filesystem::path& path, const std::string& unit);

/// Returns the code of the horizontal system, such as "EPSG:25832", or its WKT if it has none. A
/// text that GDAL does not understand is returned unchanged.
std::string normalised_crs(const std::string& crs);

/// True if both texts denote the same coordinate system.
bool is_same_crs(const std::string& one, const std::string& other);

bool is_raster_file(const std::filesystem::path& path);

}  // namespace clast::terrain_detail
