#pragma once
/// Notes on a population that qualify its figures.
#include <span>
#include <string>
#include <vector>

#include "classify/measured_block.hpp"

namespace clast {

/// Names that stand more than once, since each counts as a block of its own; unscaled blocks, since
/// they are in no size and no mass; and axes that are
/// known no better than to their own length, since such a block may be of any class. Empty when
/// there is nothing to note.
std::vector<std::string> population_notes(std::span<const MeasuredBlock> blocks);

}  // namespace clast
