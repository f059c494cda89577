#pragma once
/// The table of a GeoPackage in which QGIS keeps the styles of its layers.
#include <gdal_priv.h>

#include <filesystem>
#include <vector>

#include "report/maps/qgis_styles.hpp"

namespace clast::report_detail {

/// Adds table `layer_styles` as QGIS makes it, each style the default of its layer.
/// @param target  file, for messages
/// @throws InputError  GDAL can't write it
void add_style_table(GDALDataset& dataset, const std::filesystem::path& target,
                     const std::vector<LayerStyle>& styles);

}  // namespace clast::report_detail
