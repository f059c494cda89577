#pragma once
/// Series of varied blocks.
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "classify/form_copula.hpp"
#include "core/progress.hpp"
#include "library/block_variation.hpp"

namespace clast {

/// Request for one varied block: its parent, variation and id.
struct VariationRequest {
  const Block* parent = nullptr;
  Variation variation;
  std::string id;
  /// Blocks that are varied instead, tried in this order, if the target can't be reached from the
  /// parent.
  std::vector<const Block*> substitutes = {};
};

/// Combines all parents with all variations, by parent, then variation. Ids are PARENT_LABEL.
std::vector<VariationRequest> combine_variations(std::span<const Block* const> parents,
                                                 std::span<const Variation> variations);

struct VariationSeriesOptions {
  VariationOptions variation;
  unsigned threads = 0;  ///< number of threads; 0: one per core; does not affect the result
  ProgressCallback progress =
      {};  ///< called for each finished body, from any thread, one call at a time
};

struct VariedBlockSeries {
  std::vector<Block> blocks;          ///< finished bodies, in the order of the requests
  std::vector<std::string> failures;  ///< ids of bodies that could not be made, with reasons
};

/// Makes all requested varied blocks, in parallel.
/// @param source  library and digest, stored in all bodies
VariedBlockSeries make_variation_series(std::span<const VariationRequest> requests,
                                        const BlockSource& source,
                                        const VariationSeriesOptions& options = {});

/// Requests for bodies whose sizes and shapes were sampled from a population.
struct SampledVariationRequests {
  std::vector<VariationRequest> requests;
  CopulaFit fit;
};

/// Samples requests for varied blocks. For each sampled shape, one of the three parents with the
/// nearest shape is chosen at random and stretched to it; the others of the ten with the nearest
/// shape are its substitutes. Ids are PREFIX and a number.
/// @param parents  scanned blocks, not balls or capsules
/// @param population  sampled sizes and shapes, of a library (`block_forms`) or a table
/// @throws InputError  if there is no parent, or if `FormCopula` cannot be fitted
SampledVariationRequests sample_variation_requests(std::span<const Block* const> parents,
                                                   std::span<const BlockForm> population,
                                                   std::size_t count, std::uint64_t seed,
                                                   const std::string& prefix);

/// Returns the axes and convexity of blocks.
std::vector<BlockForm> block_forms(std::span<const Block* const> blocks);

}  // namespace clast
