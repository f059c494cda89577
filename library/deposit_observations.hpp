#pragma once
/// Observations of the blocks of scanned deposits, for the statistics of their population.
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "classify/size_draws.hpp"
#include "library/block.hpp"

namespace clast {

/// Collects what is known of blocks that were found in scans of deposits. Areas in plan take into
/// account the other blocks of the same scan.
/// @return one entry per block; empty for blocks that are not of a deposit or have no intervals
std::vector<std::optional<DepositObservation>> make_deposit_observations(
    std::span<const Block> blocks);

/// Blocks of a scanned deposit, with the numbers of blocks of the deposit for which they stand.
struct WeightedDeposit {
  std::vector<MeasuredBlock> blocks;
  std::vector<double> weights;  ///< confidence over the probability that a block is found
};

/// Weighs the blocks of a scanned deposit by the correction for blocks that do not show. Areas in
/// plan are not measured.
/// @return empty unless there are at least `kLeastCorrectedBlocks`, all of scanned deposits
std::optional<WeightedDeposit> weigh_deposit(std::span<const Block* const> blocks);

/// Draws an index with a probability proportional to its weight.
/// @param weights  not empty
std::size_t choose_by_weight(std::span<const double> weights, Random& random);

/// States that bodies are drawn from a corrected deposit, for the notes of a campaign.
std::string describe_weighted_deposit(const WeightedDeposit& deposit);

}  // namespace clast
