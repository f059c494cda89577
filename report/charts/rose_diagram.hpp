#pragma once
/// Rose diagram of axial directions.
#include <string>
#include <vector>

#include "core/statistics/axial_statistics.hpp"

namespace clast::report_detail {

/// Directions at the top and at the bottom of a rose diagram.
struct RoseDirections {
  std::string top, bottom;
};

/// Draws a rose diagram. Symmetric sectors of 15 degrees have areas proportional to the counts. A
/// line along the axial mean has the length of the resultant.
/// @param name  plain text above the diagram
/// @param trends  angles from the top to the right, rad
std::string draw_rose_diagram(const std::string& name, const std::string& colour,
                              const std::vector<double>& trends, const AxialMean& mean,
                              const RoseDirections& directions);

}  // namespace clast::report_detail
