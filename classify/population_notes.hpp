#pragma once
/// Notes on data quality that accompany the figures of a population.
#include <span>
#include <string>
#include <vector>

#include "classify/measured_block.hpp"

namespace clast {

/// Returns notes on repeated names, unscaled blocks, and axes whose error is as large as their
/// length; empty if there are none.
std::vector<std::string> population_notes(std::span<const MeasuredBlock> blocks);

}  // namespace clast
