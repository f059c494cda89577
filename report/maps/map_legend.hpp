#pragma once
/// The legend beside the map of a plan.
#include <string>

#include "report/maps/map_marks.hpp"
#include "report/maps/release_places.hpp"
#include "study/compare/comparison.hpp"

namespace clast::report_detail {

struct MapLegend {
  std::string svg;
  double bottom = 0.0;  ///< px
};

/// Site and ground zones.
/// @param contour_interval  m
MapLegend map_legend(const Comparison& comparison, const ReleasePlaces& releases,
                     const Sheet& sheet, double contour_interval);

}  // namespace clast::report_detail
