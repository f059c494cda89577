#pragma once
/// Site map as SVG.
#include <string>

#include "report/maps/site_map.hpp"

namespace clast {

/// Draws the relief lit from the north-west, with contours, zone colours, release points, barriers,
/// coordinates, legend, scale bar and north arrow.
std::string draw_svg_map(const SiteMap& site);

}  // namespace clast
