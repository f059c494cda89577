#pragma once
/// Description of scaled blocks.
#include <string>

#include "study/results/results.hpp"

namespace clast {

/// Describes the scale and mass of a block, for example "block B01 is scaled by 1.2 to 430 kg".
std::string describe_block_scale(const BlockSummary& block);

}  // namespace clast
