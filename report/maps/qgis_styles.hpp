#pragma once
/// Map layer styles for QGIS 3 (QML), which match the map of the page.
#include <string>
#include <vector>

#include "report/maps/layer_style.hpp"
#include "report/maps/map_style.hpp"
#include "study/compare/comparison.hpp"

namespace clast::report_detail {

/// Formats the style of a raster as .qml file. QGIS applies NAME.qml to NAME.tif.
std::string format_raster_qml(const ColourScale& style);

/// Makes the QGIS styles of the vector layers of a comparison.
std::vector<LayerStyle> make_vector_styles(const Comparison& comparison);

}  // namespace clast::report_detail
