#pragma once
/// Map layers for QGIS and its like.
#include <filesystem>

#include "study/compare/comparison.hpp"

namespace clast {

/// A GeoPackage with point layers `stops`, `crossings` and `measured` and line layers `barriers`
/// and `trajectories`, in map coordinates, with the terrain's CRS when it has one; `layer_styles`
/// holds how QGIS draws them: as the map of the report does.
/// @throws InputError  GDAL can't write there
void write_geopackage(const std::filesystem::path& path, const Comparison& comparison);

}  // namespace clast
