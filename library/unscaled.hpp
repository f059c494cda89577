#pragma once
/// Blocks whose shape is known and whose size is not: from photographs without any scale.
#include <string>

#include "library/block.hpp"

namespace clast {

/// Are the block's lengths in units of a model, and not in metres? Then nothing of it that holds a
/// length may be shown with a metric unit, and no mass at all.
inline bool is_unscaled(const Block& block) { return block.source.unscaled; }

/// Why such a block has no metres and no mass, and what gives it some; begins small, ends without a
/// stop: "its photographs gave no scale ...".
std::string unscaled_reason();

}  // namespace clast
