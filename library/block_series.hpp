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

struct VariationRequest {
  const Block* parent = nullptr;
  Variation variation;
  std::string id;
};

/// Combines all parents with all variations, named PARENT_LABEL: by parent, then in the given
/// order.
std::vector<VariationRequest> combine_variations(std::span<const Block* const> parents,
                                                 std::span<const Variation> variations);

struct SeriesOptions {
  VariationOptions variation;
  unsigned threads = 0;  ///< 0: one per core; does not affect the result
  ProgressCallback progress =
      {};  ///< called per finished body, from any thread, one call at a time
};

struct BlockSeries {
  std::vector<Block> blocks;          ///< in the order of the requests
  std::vector<std::string> failures;  ///< bodies that could not be made, with reasons
};

/// Makes all bodies.
/// @param source  library and digest, for all bodies
BlockSeries make_series(std::span<const VariationRequest> requests, const BlockSource& source,
                        const SeriesOptions& options = {});

/// Bodies with sizes and shapes sampled from a population.
struct SampledSeries {
  std::vector<VariationRequest> requests;
  CopulaFit fit;
};

/// Samples bodies: each is one of the three parents with the nearest shape, chosen at random,
/// stretched to the sampled shape. Ids are PREFIX and a number.
/// @param parents  scanned blocks; not balls or capsules
/// @param population  sampled shapes: `block_forms` of a library, or of a table
/// @throws InputError  if there is no parent; or as `FormCopula`
SampledSeries sample_series(std::span<const Block* const> parents,
                            std::span<const BlockForm> population, std::size_t count,
                            std::uint64_t seed, const std::string& prefix);

/// Returns the axes and convexity of blocks.
std::vector<BlockForm> block_forms(std::span<const Block* const> blocks);

}  // namespace clast
