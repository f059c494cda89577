#pragma once
/// Map layers for GIS programs.
#include <filesystem>

#include "study/compare/comparison.hpp"

namespace clast {

/// Writes a GeoPackage. It has point layers `stops`, `crossings` and `measured`, and line layers
/// `barriers` and `trajectories`, in map coordinates and with the terrain's CRS if known. The table
/// `layer_styles` gives them in QGIS the style of the report's map.
/// @throws InputError  if GDAL cannot write the file
void write_geopackage(const std::filesystem::path& path, const Comparison& comparison);

}  // namespace clast
