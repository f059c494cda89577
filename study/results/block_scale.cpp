#include "study/results/block_scale.hpp"

#include "core/number_text.hpp"

namespace clast {

std::string describe_block_scale(const BlockSummary& block) {
  return "block " + block.id + " is scaled by " + format_significant(block.scale, 4) + " to " +
         format_significant(block.mass, 4) + " kg";
}

}  // namespace clast
