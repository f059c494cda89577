#pragma once
/// Section on the population of a scanned deposit.
#include <string>

#include "report/charts/population_diagrams.hpp"

namespace clast::report_detail {

/// Formats sizes by each weighting, corrected class fractions and long axes; empty if no population
/// has blocks of a scanned deposit.
/// @param diagrams  contain "found_sizes" and "long_axes" plus suffix for each such population
std::string format_scanned_deposit_section(const PopulationReport& report,
                                           const PopulationDiagrams& diagrams);

}  // namespace clast::report_detail
