#pragma once
/// Interactive map: marks and one selectable layer over the relief, with north arrow and scale bar.
#include <string>
#include <vector>

#include "study/compare/comparison.hpp"
#include "study/compare/map_rasters.hpp"

namespace clast::report_detail {

/// Contents of an interactive map, in menu order.
struct PageMapContents {
  std::string id;     ///< of its data in the page, letters and "-", unique
  std::string label;  ///< for screen readers
  bool marks = true;  ///< stops, release points, zones and optional paths
  std::vector<const MapRasterSet*> rasters = {};
  int height = 640;  ///< px
};

/// Formats the map with controls for layer, opacity and paths. Empty if plotly.js is not installed
/// or there is nothing to show. map.js, part of `make_report_page`, draws layers, north arrow and
/// scale bar.
/// @throws InputError  if a results file can no longer be read
std::string format_page_map(const Comparison& comparison, const PageMapContents& contents);

}  // namespace clast::report_detail
