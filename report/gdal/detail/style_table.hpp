#pragma once
/// Layer styles of a GeoPackage for QGIS.
#include <gdal_priv.h>

#include <filesystem>
#include <vector>

#include "report/maps/layer_style.hpp"

namespace clast::report_detail {

/// Adds layer styles to a GeoPackage, in the table `layer_styles` that QGIS reads.
/// @param target  file name for messages
/// @throws InputError  if GDAL cannot write the table
void add_layer_style_table(GDALDataset& dataset, const std::filesystem::path& target,
                           const std::vector<LayerStyle>& styles);

}  // namespace clast::report_detail
