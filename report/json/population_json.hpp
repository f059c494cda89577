#pragma once
/// Populations of blocks as JSON (docs/formats.md).
#include <iosfwd>

#include "report/reported_population.hpp"

namespace clast {

/// Writes the output of `clast classify --json`, one line per block, without keeping all blocks in
/// memory as JSON.
void write_population_json(std::ostream& out, const PopulationReport& report);

}  // namespace clast
