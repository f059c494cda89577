#pragma once
/// Blocks that run at another size than their library has them.
#include <string>

#include "study/results/results.hpp"

namespace clast {

/// "block B01 is scaled by 1.2 to 430 kg".
std::string describe_block_scale(const BlockSummary& block);

}  // namespace clast
