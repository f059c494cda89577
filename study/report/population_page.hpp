#pragma once
/// A population, or two, as one self-contained HTML page.
#include <string>

#include "study/population_report.hpp"

namespace clast {

std::string population_page(const PopulationReport& report);

}  // namespace clast
