#pragma once
/// Styles of map layers for QGIS.
#include <string>

namespace clast::report_detail {

struct LayerStyle {
  std::string layer;
  std::string qml;
};

}  // namespace clast::report_detail
