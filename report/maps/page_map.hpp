#pragma once
/// Interactive map: relief, marks and one selectable raster layer, with north arrow and scale bar.
#include <string>
#include <vector>

#include "study/compare/comparison.hpp"
#include "study/compare/map_rasters.hpp"

namespace clast::report_detail {

/// Contents of an interactive map, in menu order.
struct PageMapContents {
  std::string id;     ///< unique id of the map in the page; letters and "-"
  std::string label;  ///< description for screen readers
  bool marks = true;  ///< true if stops, release points, zones and paths are shown
  std::vector<const MapRasterSet*> rasters = {};
  int height = 640;  ///< height of the map, px
};

/// Formats an interactive map with controls for layer, opacity and paths. Empty if plotly.js is not
/// installed or there are no contents.
/// @throws InputError  if a results file can no longer be read
std::string format_page_map(const Comparison& comparison, const PageMapContents& contents);

}  // namespace clast::report_detail
