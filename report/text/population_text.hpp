#pragma once
/// Terminal output of block populations.
#include <string>

#include "classify/population_summary.hpp"

namespace clast {

/// Formats a text table with one row per block: axes, classes, and certainty of the class.
std::string format_blocks_table(const Population& population, const PopulationOptions& options);
/// Formats class fractions and sizes of a population, and the relation of size and shape.
std::string format_population_summary(const PopulationSummary& summary);
/// Formats the comparison of two populations, with one sentence per test.
std::string format_population_comparison(const PopulationComparison& comparison);

}  // namespace clast
