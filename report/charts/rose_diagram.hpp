#pragma once
/// Rose diagram of axial directions.
#include <string>
#include <vector>

#include "core/statistics/axial_statistics.hpp"

namespace clast::report_detail {

/// Draws a rose diagram, in which downslope is upwards. Symmetric sectors of 15 degrees have areas
/// proportional to the counts. A line along the axial mean has the length of the resultant.
/// @param name  plain text above the diagram
/// @param trends  angles from downslope to the right, rad
std::string draw_rose_diagram(const std::string& name, const std::string& colour,
                              const std::vector<double>& trends, const AxialMean& mean);

}  // namespace clast::report_detail
