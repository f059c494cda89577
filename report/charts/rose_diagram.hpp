#pragma once
/// Directions of axes as a rose.
#include <string>
#include <vector>

#include "core/statistics/axial_statistics.hpp"

namespace clast::report_detail {

/// A rose of axes, downslope up and right to the right: sectors of 15 degrees, each drawn at both
/// ends, whose areas are as the numbers of axes; a line along the axial mean, as long as the
/// resultant.
/// @param name    plain text above it
/// @param trends  rad, from downslope to the right
std::string draw_rose_diagram(const std::string& name, const std::string& colour,
                         const std::vector<double>& trends, const AxialMean& mean);

}  // namespace clast::report_detail
