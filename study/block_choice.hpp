#pragma once
/// The blocks of a campaign: selected or drawn from a library, scaled, put in groups.
#include <string>
#include <vector>

#include "dem/rigid_body.hpp"
#include "library/block.hpp"
#include "study/campaign.hpp"

namespace clast {

/// A block as it runs.
struct CampaignBlock {
  std::string id;           ///< of the library block; when drawn "SP1A#7", the seventh draw
  std::size_t library = 0;  ///< into BlockChoice::library
  double scale = 1.0;       ///< of lengths
  std::size_t group = 0;    ///< 0: none, else 1 + index into Campaign::groups
};

struct BlockChoice {
  std::vector<Block> library;  ///< those that occur, unscaled
  /// Where blocks stay, drawn ones are those of all realisations, one after the other.
  std::vector<CampaignBlock> blocks;
};

/// Selects, draws and scales as [blocks] and [[block_group]] ask.
/// @throws InputError  a missing id; nothing selected; an unscaled block that is not brought to a
///                     mass or a volume; a class that shall be drawn and has no block; a group
///                     without a block, or a block in two groups
BlockChoice choose_blocks(const Campaign& campaign);

/// How many of `count` go to each share: whole numbers, largest remainders first.
std::vector<std::size_t> quotas(const std::vector<double>& shares, std::size_t count);

/// The same shape and density at another size: lengths times `factor`, mass times its cube, moments
/// times its fifth power.
RigidBody scaled(RigidBody body, double factor);

}  // namespace clast
