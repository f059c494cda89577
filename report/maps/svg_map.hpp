#pragma once
/// The map of a site as a picture of its own.
#include <string>

#include "report/maps/site_map.hpp"

namespace clast {

/// An SVG file: relief lit from the north-west with contours and tinted zones, release points and
/// barriers, with coordinates, legend, scale bar and north arrow.
std::string draw_svg_map(const SiteMap& site);

}  // namespace clast
