#pragma once
/// Layer styles of a GeoPackage for QGIS.
#include <gdal_priv.h>

#include <filesystem>
#include <vector>

#include "report/maps/qgis_styles.hpp"

namespace clast::report_detail {

/// Adds the table `layer_styles` of QGIS. Each style is the default of its layer.
/// @param target  file name for messages
/// @throws InputError  if GDAL cannot write it
void add_layer_style_table(GDALDataset& dataset, const std::filesystem::path& target,
                           const std::vector<LayerStyle>& styles);

}  // namespace clast::report_detail
