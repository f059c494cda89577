#pragma once
/// Settling of the blocks of a virtual deposit under gravity.
#include <optional>
#include <span>
#include <vector>

#include "samples/deposit/deposit_block.hpp"

namespace clast {

/// Returns the slope of the floor under a kind of deposit, rad. The floor passes through the origin
/// and falls along +x.
double floor_slope(DepositKind kind);

/// Returns how many blocks are released so that `recipe.blocks` remain: some roll far away.
std::size_t count_released_blocks(const DepositRecipe& recipe);

/// Releases the cores one batch after the other from close above those that already lie there, and
/// lets them come to rest on the floor (`World`). Those that rolled farthest are then removed,
/// until `recipe.blocks` remain.
/// @param blocks  as many as `count_released_blocks`
/// @return world_from_body of each block; empty for blocks that were removed, left the floor or did
///         not come to rest
std::vector<std::optional<Pose>> settle_blocks(const DepositRecipe& recipe,
                                               std::span<const VirtualBlock> blocks,
                                               unsigned threads);

}  // namespace clast
