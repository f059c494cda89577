#pragma once
/// Assignment of the blocks of a realisation to multi-block releases.
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "study/simulate/campaign_runner.hpp"

namespace clast::study_detail {

/// Returns "[mass] upper", or "[mass]" for a single unnamed release.
std::string multi_block_release_name(const Campaign& campaign, std::size_t mass);

/// Returns the number of blocks of each heap: its count, its fraction, or in proportion to the
/// polygon area; integers by the largest-remainder method.
/// @param blocks  number of blocks of a realisation
/// @throws InputError  if the numbers do not add up, or a heap is empty
std::vector<std::size_t> blocks_per_release(const Campaign& campaign, std::size_t blocks);

/// Distributes the blocks of a realisation in placing order: consecutive blocks of `order` to
/// heaps, blocks in place to the polygon that contains their centre.
/// @param prepared  with campaign, blocks and terrain
/// @param order  all blocks of the realisation
/// @throws InputError  as `blocks_per_release`; if a block in place is in no polygon or in two; or
///                     if a release in place has no block
std::vector<std::vector<std::uint32_t>> distribute_blocks(const CampaignPlan& prepared,
                                                          std::span<const std::uint32_t> order);

}  // namespace clast::study_detail
