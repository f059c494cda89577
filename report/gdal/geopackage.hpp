#pragma once
/// Map layers for GIS programs.
#include <filesystem>

#include "study/compare/comparison.hpp"

namespace clast {

/// Writes a GeoPackage with the stops, crossings, observed stops, barriers and trajectories of a
/// comparison, in map coordinates. QGIS draws the layers in the style of the report.
/// @throws InputError  if GDAL cannot write the file
void write_geopackage(const std::filesystem::path& path, const Comparison& comparison);

}  // namespace clast
