#pragma once
/// Shapes of marks on maps.

namespace clast::report_detail {

/// Names of a mark shape in plotly.js and in QGIS.
struct MarkShape {
  const char* plotly;
  const char* qgis;
  int qgis_angle = 0;  ///< clockwise rotation, degrees
};

}  // namespace clast::report_detail
