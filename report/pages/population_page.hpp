#pragma once
/// A population, or two, as one self-contained HTML page.
#include <string>

#include "report/charts/population_diagrams.hpp"

namespace clast::report_detail {

/// @param diagrams  of the report, see `draw_population_diagrams`
std::string make_population_page(const PopulationReport& report, const Diagrams& diagrams);

}  // namespace clast::report_detail
