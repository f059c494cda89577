#pragma once
/// Rasters through GDAL, with no GDAL type in sight.
#include <filesystem>
#include <string>
#include <vector>

#include "core/output_file.hpp"
#include "terrain/detail/raw_surface.hpp"

namespace clast::terrain_detail {

/// One band on a north-up grid. Heights of a digital elevation model, or class numbers.
struct Raster {
  HeightGrid grid;
  std::string crs;  ///< of the plan, "EPSG:2154" or WKT; empty when there is none
};

/// Reads a raster with one band; rows that run north are turned over.
/// @throws InputError  not a raster, without georeference, several bands, rotated, in degrees, plan
/// or heights not in metres
Raster read_raster(const std::filesystem::path& path);

/// Refuses a map system in degrees or feet, or with heights in feet.
/// @param name  of the file, for the message
/// @param crs   as GDAL understands it; one that it does not is let through
/// @param way   how to bring the file to metres
/// @throws InputError
void check_metres(const std::string& name, const std::string& crs, const std::string& way);

/// Writes heights as GeoTIFF (float, deflated, nodata -9999), north up.
void write_geotiff(const std::filesystem::path& path, const HeightGrid& grid,
                   const std::string& crs, const OutputRules& rules = {});

/// True when both name the same coordinate system, whichever way it is written.
bool same_crs(const std::string& one, const std::string& other);

/// Extensions that are taken for rasters.
bool is_raster(const std::filesystem::path& path);

}  // namespace clast::terrain_detail
