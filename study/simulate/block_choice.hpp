#pragma once
/// The blocks of a campaign: selected or drawn from a library, scaled, put in groups.
#include <string>
#include <utility>
#include <vector>

#include "core/progress.hpp"
#include "dem/motion/rigid_body.hpp"
#include "library/block.hpp"
#include "study/campaign/campaign.hpp"

namespace clast {

/// A block as it runs.
struct CampaignBlock {
  std::string id;           ///< of the library block; when drawn "SP1A#7", the seventh draw
  std::size_t library = 0;  ///< into BlockChoice::library
  double scale = 1.0;       ///< of lengths
  std::size_t group = 0;    ///< 0: none, else 1 + index into Campaign::groups
};

struct BlockChoice {
  std::vector<Block> library;        ///< those that occur, unscaled
  std::vector<std::string> parents;  ///< blocks that the others were made of; empty: none was made
  std::vector<std::string> notes;    ///< on a table that forms were drawn from
  /// Where blocks stay, drawn ones are those of all realisations, one after the other.
  std::vector<CampaignBlock> blocks;
};

/// How blocks are made where the campaign varies them; no matter for what is made.
struct BlockPreparationOptions {
  unsigned threads = 0;    ///< 0: one per core
  ProgressCallback progress = {};  ///< bodies made, from any thread, one at a time
};

/// Selects, varies, draws and scales as [blocks] and [[block_group]] ask. Bodies that are made run
/// in order of their ids, as from a library.
/// @throws InputError  a missing id; nothing selected; an unscaled block that is not brought to a
///                     mass or a volume; a class that shall be drawn and has no block; a group
///                     without a block, that names a block which is not there, or a block in two
///                     groups; a body that is asked for twice
/// @throws GeometryError  a body that can't be made
BlockChoice choose_blocks(const Campaign& campaign, const BlockPreparationOptions& making = {});

/// The blocks that [blocks] selects of its library, unscaled: what a draw draws from.
/// @throws InputError  a missing id, or nothing selected
std::vector<Block> read_selected_blocks(const Campaign& campaign);

/// Draws as [blocks] draw asks.
/// @param pool  selected blocks; those drawn name their places in it
/// @throws InputError  a class that shall be drawn and has no block; shares as `class_fractions`; a
///                     volume of less than half a block or of too many
std::vector<CampaignBlock> draw_blocks(const Campaign& campaign, const std::vector<Block>& pool);

/// Shares of the classes of a draw, sum 1; empty: as they are. Shares that are set stay, the other
/// classes divide what is left in the proportions that they have.
/// @throws InputError  those set add up to more than 1, or to less and there is no other class
std::vector<std::pair<std::string, double>> class_fractions(const BlockSampling& draw);

/// How many of `count` go to each share: whole numbers, largest remainders first.
std::vector<std::size_t> allocate_quotas(const std::vector<double>& shares, std::size_t count);

/// The same shape and density at another size: lengths times `factor`, mass times its cube, moments
/// times its fifth power.
RigidBody scaled(RigidBody body, double factor);

}  // namespace clast
