#pragma once
/// Which blocks of a realisation belong to which of its rock masses.
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "study/simulate/campaign_runner.hpp"

namespace clast::study_detail {

/// "[mass] upper"; "[mass]" where there is only one without a name.
std::string multi_block_release_name(const Campaign& campaign, std::size_t mass);

/// How many blocks each heap has: its count, its share, or by the area of its polygon of what those
/// leave; whole numbers, largest remainders first.
/// @param blocks  of a realisation
/// @throws InputError  they do not add up to all blocks, or a heap has none
std::vector<std::size_t> blocks_per_release(const Campaign& campaign, std::size_t blocks);

/// Blocks of each mass in the order that they are placed in: of heaps the first ones of `order` go
/// to the first heap, in place each belongs to the polygon that its centre lies in.
/// @param prepared  with campaign, blocks and terrain
/// @param order     all blocks of the realisation
/// @throws InputError  as `blocks_per_release`; a block in place in no polygon, or in two; a mass in place
///                     without a block
std::vector<std::vector<std::uint32_t>> distribute_blocks(const CampaignPlan& prepared,
                                                         std::span<const std::uint32_t> order);

}  // namespace clast::study_detail
