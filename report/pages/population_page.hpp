#pragma once
/// Report of one or two populations as one self-contained HTML page.
#include <string>

#include "report/charts/population_diagrams.hpp"

namespace clast::report_detail {

/// Makes the report page of one or two populations.
/// @param diagrams  result of `draw_population_diagrams`
std::string make_population_page(const PopulationReport& report,
                                 const PopulationDiagrams& diagrams);

}  // namespace clast::report_detail
