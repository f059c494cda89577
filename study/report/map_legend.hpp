#pragma once
/// The legend beside a report's map.
#include <string>

#include "study/comparison.hpp"
#include "study/report/map_marks.hpp"

namespace clast {

struct MapLegend {
  std::string svg;
  double bottom = 0.0;  ///< px
};

/// Classes, blocks (a click hides their stops), site and ground zones.
/// @param contour_interval  m
/// @param density           stops are drawn as a density
MapLegend map_legend(const Comparison& comparison, const Sheet& sheet, double contour_interval,
                     bool density);

}  // namespace clast
