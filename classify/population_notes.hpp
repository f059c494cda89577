#pragma once
/// What a reader of a population should know before believing its figures.
#include <span>
#include <string>
#include <vector>

#include "classify/measured_block.hpp"

namespace clast {

/// Names that stand more than once, since each counts as a block of its own; unscaled blocks, since
/// they are in no size and no mass; and axes that are
/// known no better than to their own length, since nothing can be said of such a block's class.
/// Empty when there is nothing to say.
std::vector<std::string> population_notes(std::span<const MeasuredBlock> blocks);

}  // namespace clast
