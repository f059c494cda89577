#pragma once
/// Populations of blocks as JSON (docs/formats.md).
#include <iosfwd>

#include "report/reported_population.hpp"

namespace clast {

/// Writes the JSON of `clast classify --json`, with one line per block. Blocks are written one by
/// one to limit the memory.
void write_population_json(std::ostream& out, const PopulationReport& report);

}  // namespace clast
