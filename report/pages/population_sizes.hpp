#pragma once
/// Sizes of the blocks of a population: curves, fitted laws, and how shape goes with size.
#include <string>

#include "report/charts/population_diagrams.hpp"

namespace clast::report_detail {

/// Characters of a population's name over a column.
inline constexpr std::size_t kMostHead = 14;

/// The section of the page.
/// @param diagrams  with "sizes" where there are several populations, and "size" + suffix of each
std::string format_size_section(const PopulationReport& report, const Diagrams& diagrams);

}  // namespace clast::report_detail
