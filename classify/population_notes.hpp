#pragma once
/// Notes on the data quality of a population.
#include <span>
#include <string>
#include <vector>

#include "classify/measured_block.hpp"

namespace clast {

/// Returns notes on repeated names, unscaled blocks, and axes no longer than their error.
std::vector<std::string> population_notes(std::span<const MeasuredBlock> blocks);

}  // namespace clast
