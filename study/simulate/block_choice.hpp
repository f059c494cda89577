#pragma once
/// Blocks of a campaign: selected or sampled from a library, scaled, assigned to groups.
#include <string>
#include <utility>
#include <vector>

#include "core/progress.hpp"
#include "dem/motion/rigid_body.hpp"
#include "library/block.hpp"
#include "study/campaign/campaign.hpp"

namespace clast {

struct CampaignBlock {
  std::string id;  ///< of the library block; for sampled blocks "SP1A#7", the seventh sample
  std::size_t library = 0;  ///< used library blocks, unscaled
  double scale = 1.0;       ///< of lengths
  std::size_t group = 0;    ///< 0: no group; otherwise 1 + index into Campaign::groups
};

/// Blocks of a campaign and the library blocks they are made of.
struct CampaignBlocks {
  std::vector<Block> library;        ///< those that occur, unscaled
  std::vector<std::string> parents;  ///< blocks from which others were varied; empty if none was
  std::vector<std::string> notes;    ///< remarks on a table that forms were sampled from
  /// Persistent sampled blocks are listed realisation by realisation.
  std::vector<CampaignBlock> blocks;
};

/// Execution options for varying blocks; they do not affect the result.
struct BlockPreparationOptions {
  unsigned threads = 0;  ///< 0: one per core
  ProgressCallback progress =
      {};  ///< called per finished body, from any thread, one call at a time
};

/// Selects, varies, samples and scales blocks as [blocks] and [[block_group]] state. Varied bodies
/// are ordered by id.
/// @throws InputError  if an id is missing; nothing is selected; an unscaled block is not given a
///                     mass or volume; a sampled class has no block; a group has no block, names an
///                     unknown block or shares one with another group; or a body is requested twice
/// @throws GeometryError  if a body cannot be made
CampaignBlocks choose_blocks(const Campaign& campaign, const BlockPreparationOptions& making = {});

/// Reads the library blocks that [blocks] selects, unscaled, before sampling.
/// @throws InputError  if an id is missing or nothing is selected
std::vector<Block> read_selected_blocks(const Campaign& campaign);

/// Samples blocks as `draw` in [blocks] states.
/// @param pool  selected blocks; samples refer to them by index
/// @throws InputError  if a sampled class has no block, class fractions are invalid
///                     (`class_fractions`), or the volume is less than half a block or needs too
///                     many blocks
std::vector<CampaignBlock> sample_blocks(const Campaign& campaign, const std::vector<Block>& pool);

/// Returns the class fractions of a sampling, sum 1; empty: those of the selection. Fixed fractions
/// are kept; the other classes share the rest in their proportions.
/// @throws InputError  if the fixed fractions exceed 1, or are below 1 without another class
std::vector<std::pair<std::string, double>> class_fractions(const BlockSampling& draw);

/// Allocates `count` items to fractions by the largest-remainder method.
std::vector<std::size_t> allocate_quotas(const std::vector<double>& shares, std::size_t count);

/// Scales a body at constant shape and density: lengths by `factor`, mass by its cube, moments of
/// inertia by its fifth power.
RigidBody scaled(RigidBody body, double factor);

}  // namespace clast
