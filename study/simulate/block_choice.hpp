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
  std::string id;  ///< id of the library block; with a number for sampled blocks, such as "SP1A#7"
  std::size_t library = 0;  ///< index into CampaignBlocks::library
  double scale = 1.0;       ///< scale of lengths
  std::size_t group = 0;    ///< 0 if in no group; otherwise 1 + index into Campaign::groups
};

/// Blocks of a campaign and the library blocks from which they are made.
struct CampaignBlocks {
  std::vector<Block> library;        ///< unscaled library blocks
  std::vector<std::string> parents;  ///< ids of blocks from which others were varied
  /// Notes on the table or the deposit from which blocks or shapes were sampled.
  std::vector<std::string> notes;
  /// Blocks of the campaign; sampled persistent blocks are ordered by realisation.
  std::vector<CampaignBlock> blocks;
};

/// Number of threads and progress function for the preparation of blocks. They do not affect the
/// result.
struct BlockPreparationOptions {
  unsigned threads = 0;  ///< number of threads; 0: one per core
  /// Function called for each finished body, from any thread, one call at a time.
  ProgressCallback progress = {};
};

/// Selects, varies, samples and scales the blocks of a campaign and assigns them to groups.
/// @throws InputError  if an id is missing, nothing is selected, a block has no scale, a sampled
///                     class or a group has no block, or a block is in two groups
/// @throws GeometryError  if a body cannot be made
CampaignBlocks choose_campaign_blocks(const Campaign& campaign,
                                      const BlockPreparationOptions& preparation = {});

/// Reads the library blocks that a campaign selects, neither sampled nor scaled.
/// @throws InputError  if an id is missing or nothing is selected
std::vector<Block> read_selected_blocks(const Campaign& campaign);

/// Samples the blocks of a campaign at random from the selected library blocks. Blocks of a scanned
/// deposit are drawn in the numbers for which they stand (`weigh_deposit`), and scaled to sizes
/// within their intervals unless masses are drawn.
/// @param pool  selected blocks, to which samples refer by index
/// @throws InputError  if a sampled class has no block, class fractions are invalid, or the
///                     requested volume needs less than half a block or too many
std::vector<CampaignBlock> sample_blocks(const Campaign& campaign, const std::vector<Block>& pool);

/// Returns the fraction of each class in a random sampling, with sum 1. Empty if the fractions of
/// the selected blocks are used.
/// @throws InputError  if the given fractions do not add up to 1
std::vector<std::pair<std::string, double>> class_fractions(const BlockSampling& draw);

/// Divides `count` items by fractions, using the largest-remainder method.
std::vector<std::size_t> allocate_quotas(const std::vector<double>& shares, std::size_t count);

/// Scales a body at constant shape and density. Lengths are multiplied by `factor`, the mass by its
/// cube, and moments of inertia by its fifth power.
RigidBody scaled(RigidBody body, double factor);

}  // namespace clast
