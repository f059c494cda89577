#pragma once
/// Section on block sizes: distributions, fitted laws, and relation of shape and size.
#include <string>

#include "report/charts/population_diagrams.hpp"

namespace clast::report_detail {

/// Maximum number of characters of the name of a population in a column head.
inline constexpr std::size_t kMaxHeadLength = 14;

/// Formats the section on block sizes.
/// @param diagrams  contain "sizes" if there are two populations, and "size" plus suffix for each
std::string format_size_section(const PopulationReport& report, const PopulationDiagrams& diagrams);

}  // namespace clast::report_detail
