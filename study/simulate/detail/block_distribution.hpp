#pragma once
/// Assignment of the blocks of a realisation to multi-block releases.
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "study/simulate/campaign_runner.hpp"

namespace clast::study_detail {

/// Returns the name of a simultaneous release for messages, such as "[mass] upper".
std::string multi_block_release_name(const Campaign& campaign, std::size_t mass);

/// Returns the number of blocks of each heap, from its count, its fraction or the area of its
/// outline.
/// @param blocks  number of blocks of a realisation
/// @throws InputError  if the numbers do not add up, or a heap is empty
std::vector<std::size_t> blocks_per_release(const Campaign& campaign, std::size_t blocks);

/// Distributes the blocks of a realisation to its simultaneous releases.
/// @param prepared  plan with campaign, blocks and terrain
/// @param order  all blocks of the realisation, in placing order
/// @throws InputError  if `blocks_per_release` throws, a block in place is in no polygon or in two,
///                     or a release in place has no block
std::vector<std::vector<std::uint32_t>> distribute_blocks(const CampaignPlan& prepared,
                                                          std::span<const std::uint32_t> order);

}  // namespace clast::study_detail
