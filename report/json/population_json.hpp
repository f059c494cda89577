#pragma once
/// Populations of blocks as JSON (docs/formats.md).
#include <iosfwd>

#include "report/reported_population.hpp"

namespace clast {

/// Writes block populations as JSON, with one line per block.
void write_population_json(std::ostream& out, const PopulationReport& report);

}  // namespace clast
