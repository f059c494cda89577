#pragma once
/// Blocks of a campaign, selected or sampled from a library, scaled, and assigned to groups.
#include <string>
#include <utility>
#include <vector>

#include "core/progress.hpp"
#include "dem/motion/rigid_body.hpp"
#include "library/block.hpp"
#include "study/campaign/campaign.hpp"

namespace clast {

struct CampaignBlock {
  std::string id;  ///< id of the library block; for sampled blocks, with a number: "SP1A#7"
  std::size_t library = 0;  ///< index into CampaignBlocks::library
  double scale = 1.0;       ///< scale of lengths
  std::size_t group = 0;    ///< 0: no group; otherwise 1 + index into Campaign::groups
};

/// Blocks of a campaign and the library blocks from which they are made.
struct CampaignBlocks {
  std::vector<Block> library;        ///< library blocks that occur, unscaled
  std::vector<std::string> parents;  ///< ids of blocks from which others were varied
  std::vector<std::string> notes;    ///< notes on the table from which shapes were sampled
  /// Blocks of the campaign. Persistent sampled blocks are ordered by realisation.
  std::vector<CampaignBlock> blocks;
};

/// Execution options for varying blocks; they do not affect the result.
struct BlockPreparationOptions {
  unsigned threads = 0;  ///< number of threads; 0: one per core
  ProgressCallback progress =
      {};  ///< called for each finished body, from any thread, one call at a time
};

/// Selects, varies, samples and scales blocks for [blocks] and [[block_group]]; varied ones by id.
/// @throws InputError  if an id is missing, nothing is selected, a block without scale gets no mass
///                     or volume, a sampled class has no block, a group has no block, names an
///                     unknown block or shares one with another group, or a body is requested twice
/// @throws GeometryError  if a body cannot be made
CampaignBlocks choose_campaign_blocks(const Campaign& campaign,
                                      const BlockPreparationOptions& preparation = {});

/// Reads the library blocks that [blocks] selects. They are neither sampled nor scaled.
/// @throws InputError  if an id is missing or nothing is selected
std::vector<Block> read_selected_blocks(const Campaign& campaign);

/// Samples blocks as requested by `draw` in [blocks].
/// @param pool  selected blocks, to which samples refer by index
/// @throws InputError  if a sampled class has no block, class fractions are invalid
///                     (`class_fractions`), or the requested volume is less than half a block or
///                     needs too many blocks
std::vector<CampaignBlock> sample_blocks(const Campaign& campaign, const std::vector<Block>& pool);

/// Returns the class fractions of a sampling, with sum 1. If empty, those of the selection are
/// used. Fractions in `set_shares` are kept; the other classes share the rest in their proportions.
/// @throws InputError  if fractions in `set_shares` exceed 1, or are below 1 without another class
std::vector<std::pair<std::string, double>> class_fractions(const BlockSampling& draw);

/// Divides `count` items by fractions, using the largest-remainder method.
std::vector<std::size_t> allocate_quotas(const std::vector<double>& shares, std::size_t count);

/// Scales a body at constant shape and density. Lengths are multiplied by `factor`, the mass by its
/// cube, and moments of inertia by its fifth power.
RigidBody scaled(RigidBody body, double factor);

}  // namespace clast
