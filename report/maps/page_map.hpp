#pragma once
/// The map of a page: marks and one layer at a time over the relief, with north arrow and scale
/// bar.
#include <string>
#include <vector>

#include "study/compare/comparison.hpp"
#include "study/compare/map_rasters.hpp"

namespace clast::report_detail {

/// What is on a map beside barriers, and in what order it can be chosen.
struct PageMapContents {
  std::string id;     ///< of its data in the page, letters and "-": one map, one id
  std::string label;  ///< for those who don't see it
  bool marks = true;  ///< stops, release points and zones, and paths on request
  std::vector<const MapRasterSet*> rasters = {};
  int height = 640;  ///< px
};

/// The map with its controls: what is shown, how opaque, and paths. Empty where plotly.js is not
/// installed, and where there is nothing to show. map.js, which `make_report_page` has, draws layers,
/// north arrow and scale bar.
/// @throws InputError  a results file can't be read any more
std::string format_page_map(const Comparison& comparison, const PageMapContents& contents);

}  // namespace clast::report_detail
