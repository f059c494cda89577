#pragma once
/// Observations of the blocks of scanned deposits, for the statistics of their population.
#include <optional>
#include <span>
#include <vector>

#include "classify/deposit_observation.hpp"
#include "library/block.hpp"

namespace clast {

/// Collects what is known of blocks that were found in scans of deposits. Areas in plan take into
/// account the other blocks of the same scan.
/// @return one entry per block; empty for blocks that are not of a deposit or have no intervals
std::vector<std::optional<DepositObservation>> make_deposit_observations(
    std::span<const Block> blocks);

}  // namespace clast
