#pragma once
/// Assignment of the blocks of a realisation to multi-block releases.
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "study/simulate/campaign_runner.hpp"

namespace clast::study_detail {

/// Returns the name of a release for messages: "[mass] upper", or "[mass]" if it has none.
std::string multi_block_release_name(const Campaign& campaign, std::size_t mass);

/// Returns the number of blocks of each heap, as given by its count, its fraction or its polygon
/// area. Numbers are rounded by the largest-remainder method.
/// @param blocks  number of blocks of a realisation
/// @throws InputError  if the numbers do not add up, or a heap is empty
std::vector<std::size_t> blocks_per_release(const Campaign& campaign, std::size_t blocks);

/// Distributes the blocks of a realisation to the releases. Heaps get consecutive blocks of
/// `order`. Blocks that are released in place belong to the polygon that contains their centre.
/// @param prepared  plan with campaign, blocks and terrain
/// @param order  all blocks of the realisation, in placing order
/// @throws InputError  if `blocks_per_release` throws, a block in place is in no polygon or in two,
///                     or a release in place has no block
std::vector<std::vector<std::uint32_t>> distribute_blocks(const CampaignPlan& prepared,
                                                          std::span<const std::uint32_t> order);

}  // namespace clast::study_detail
