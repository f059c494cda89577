#pragma once
/// A population, or two, as one self-contained HTML page.
#include <string>

#include "report/charts/population_diagrams.hpp"

namespace clast::report_detail {

/// @param diagrams  of the report, see `population_diagrams`
std::string population_page(const PopulationReport& report, const Diagrams& diagrams);

}  // namespace clast::report_detail
