#pragma once
/// Populations of blocks as JSON (docs/formats.md).
#include <iosfwd>

#include "report/reported_population.hpp"

namespace clast {

/// The object that `clast classify --json` prints; a line per block, so that a million of them are
/// never in memory as JSON.
void write_population_json(std::ostream& out, const PopulationReport& report);

}  // namespace clast
