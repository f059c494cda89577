#pragma once
/// Many variations of blocks of a library at once.
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "classify/form_copula.hpp"
#include "core/progress.hpp"
#include "library/block_variation.hpp"

namespace clast {

/// One body that is wanted.
struct VariationRequest {
  const Block* parent = nullptr;
  Variation variation;
  std::string id;
};

/// Every variation of every parent, named PARENT_LABEL: by parent, then in the order given.
std::vector<VariationRequest> combine_variations(std::span<const Block* const> parents,
                                                 std::span<const Variation> variations);

struct SeriesOptions {
  VariationOptions variation;
  unsigned threads = 0;            ///< 0: one per core; changes no bit of the result
  ProgressCallback progress = {};  ///< bodies made, from any thread, one at a time
};

struct BlockSeries {
  std::vector<Block> blocks;          ///< in the order of the requests
  std::vector<std::string> failures;  ///< bodies that could not be made, and why
};

/// @param source  of all: the library and its hash
BlockSeries make_series(std::span<const VariationRequest> requests, const BlockSource& source,
                        const SeriesOptions& options = {});

/// Bodies with sizes and forms drawn from a population.
struct SampledSeries {
  std::vector<VariationRequest> requests;
  CopulaFit fit;
};

/// Bodies to be made: each one of the parents, at random among the three whose form is nearest,
/// stretched to what was drawn. Ids are PREFIX and a number.
/// @param parents     scanned blocks; not balls or capsules
/// @param population  what is drawn from: `block_forms` a library, or a table's
/// @throws InputError  no parent; as `FormCopula`
SampledSeries sample_series(std::span<const Block* const> parents,
                            std::span<const BlockForm> population, std::size_t count,
                            std::uint64_t seed, const std::string& prefix);

/// Axes and convexity of blocks.
std::vector<BlockForm> block_forms(std::span<const Block* const> blocks);

}  // namespace clast
