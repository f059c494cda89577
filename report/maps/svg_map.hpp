#pragma once
/// Site map as SVG.
#include <string>

#include "report/maps/site_map.hpp"

namespace clast {

/// Draws a site map as SVG: shaded relief, contours, zones, release points, barriers, coordinates,
/// legend, scale bar and north arrow.
std::string draw_svg_map(const SiteMap& site);

}  // namespace clast
