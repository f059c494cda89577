#pragma once
/// Legend of a site map.
#include <string>

#include "report/maps/map_marks.hpp"

namespace clast::report_detail {

struct MapLegend {
  std::string svg;
  double bottom = 0.0;  ///< lower edge, px
};

/// Draws the legend of a site map: marks and ground zones.
MapLegend draw_map_legend(const SiteMap& site, const MapToPixels& sheet);

}  // namespace clast::report_detail
