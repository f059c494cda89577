#pragma once
/// Unscaled blocks, which were made from photographs without a scale.
#include <string>

#include "library/block.hpp"

namespace clast {

/// True if lengths are in model units rather than metres. Such lengths must not be shown with
/// metric units, and the mass not at all.
inline bool is_unscaled(const Block& block) { return block.source.unscaled; }

/// Explains why a block is unscaled and how to scale it: "its photographs gave no scale ...".
std::string explain_unscaled_block();

}  // namespace clast
