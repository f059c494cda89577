#pragma once
/// Populations as text for a terminal.
#include <string>

#include "classify/population_summary.hpp"

namespace clast {

/// A row per block: axes, classes, and how sure the class of the first scheme is.
std::string format_blocks_table(const Population& population, const PopulationOptions& options);
/// Shares of classes, sizes, and how size and shape go together.
std::string format_population_summary(const PopulationSummary& summary);
/// A sentence per test.
std::string format_population_comparison(const PopulationComparison& comparison);

}  // namespace clast
