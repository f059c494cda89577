#pragma once
/// Styles of map layers as QGIS 3 reads them (QML), the same as on the map of a page.
#include <string>
#include <vector>

#include "report/maps/map_style.hpp"
#include "study/compare/comparison.hpp"

namespace clast::report_detail {

/// A .qml file beside a raster: QGIS opens NAME.tif with NAME.qml.
std::string format_raster_qml(const ValueStyle& style);

/// The style of a layer of the GeoPackage.
struct LayerStyle {
  std::string layer;
  std::string qml;
};

/// Stops by block, crossings and trajectories by shape class, barriers with their names, and stops
/// observed in the field where there are some.
std::vector<LayerStyle> make_vector_styles(const Comparison& comparison);

}  // namespace clast::report_detail
