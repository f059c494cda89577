#pragma once
/// Rasters through GDAL, with no GDAL type in sight.
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "terrain/raw_surface.hpp"

namespace clast::terrain_detail {

/// One band on a north-up grid. Heights of a digital elevation model, or class numbers.
struct Raster {
  HeightGrid grid;
  std::string crs;                 ///< of the plan, "EPSG:2154" or WKT; empty when there is none
  std::string unit;                ///< that the band names for its values; empty when it names none
  std::optional<double> no_data;   ///< that the band declares
  std::vector<std::string> notes;  ///< on its reference system
};

/// Reads a raster with one band; rows that run north are turned over.
/// @throws InputError  not a raster, without georeference, several bands, rotated, in degrees, plan
/// or heights not in metres by its reference system, or a map that stretches lengths
Raster read_raster(const std::filesystem::path& path);

/// Refuses heights whose band names another unit than the metre, or one that is not known.
/// @throws InputError
void check_height_unit(const std::filesystem::path& path, const std::string& unit);

/// "EPSG:25832" when the plan of a reference system has a code, else its WKT; the text itself where
/// GDAL does not understand it.
std::string normalised_crs(const std::string& crs);

/// True when both name the same coordinate system, whichever way it is written.
bool is_same_crs(const std::string& one, const std::string& other);

/// Extensions that are taken for rasters.
bool is_raster_file(const std::filesystem::path& path);

}  // namespace clast::terrain_detail
