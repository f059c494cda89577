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
  std::string crs;                 ///< of the plan, "EPSG:2154" or WKT; empty if unknown
  std::string unit;                ///< of the values as declared by the band; empty if not declared
  std::optional<double> no_data;   ///< declared by the band
  std::vector<std::string> notes;  ///< on its reference system
};

/// Reads a raster with one band; rows from south to north are reversed.
/// @throws InputError  if it is not a raster, not georeferenced, has several bands, is rotated or
///                     in degrees, has plan or height units other than metres, or a projection that
///                     distorts lengths
Raster read_raster(const std::filesystem::path& path);

/// Checks that the height unit is the metre or not declared.
/// @throws InputError  if it is not
void check_height_unit(const std::filesystem::path& path, const std::string& unit);

/// Returns "EPSG:25832" if the plan system has a code, otherwise its WKT; the text itself if GDAL
/// does not understand it.
std::string normalised_crs(const std::string& crs);

/// True if both texts denote the same coordinate system.
bool is_same_crs(const std::string& one, const std::string& other);

bool is_raster_file(const std::filesystem::path& path);

}  // namespace clast::terrain_detail
