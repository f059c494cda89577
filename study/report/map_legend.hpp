#pragma once
/// The legend beside the map of a plan.
#include <string>

#include "study/comparison.hpp"
#include "study/report/map_marks.hpp"

namespace clast {

struct MapLegend {
  std::string svg;
  double bottom = 0.0;  ///< px
};

/// Site and ground zones.
/// @param contour_interval  m
MapLegend map_legend(const Comparison& comparison, const Sheet& sheet, double contour_interval);

}  // namespace clast
