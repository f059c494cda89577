#pragma once
/// Rose diagram of axial directions.
#include <string>
#include <vector>

#include "core/statistics/axial_statistics.hpp"

namespace clast::report_detail {

/// Draws a rose diagram, downslope upwards and right to the right: symmetric sectors of 15 degrees
/// with areas proportional to the counts, and a line along the axial mean with the length of the
/// resultant.
/// @param name  plain text above the diagram
/// @param trends  rad, from downslope to the right
std::string draw_rose_diagram(const std::string& name, const std::string& colour,
                              const std::vector<double>& trends, const AxialMean& mean);

}  // namespace clast::report_detail
