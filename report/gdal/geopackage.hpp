#pragma once
/// Map layers for GIS programs.
#include <filesystem>

#include "study/compare/comparison.hpp"

namespace clast {

/// Writes a GeoPackage with point layers `stops`, `crossings` and `measured`, line layers
/// `barriers` and `trajectories`, in map coordinates and the terrain's CRS if known, and
/// `layer_styles` for QGIS that match the report's map.
/// @throws InputError  if GDAL cannot write the file
void write_geopackage(const std::filesystem::path& path, const Comparison& comparison);

}  // namespace clast
