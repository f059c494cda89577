#pragma once
/// Section on block sizes: distributions, fitted laws, and relation of shape and size.
#include <string>

#include "report/charts/population_diagrams.hpp"

namespace clast::report_detail {

/// Maximum length of a population's name in a column head, characters.
inline constexpr std::size_t kMostHead = 14;

/// Formats the section.
/// @param diagrams  contains "sizes" for several populations, and "size" plus suffix for each
std::string format_size_section(const PopulationReport& report, const Diagrams& diagrams);

}  // namespace clast::report_detail
