#pragma once
/// Greedy merging of patches into regions that are parts of single bodies.
#include <cstdint>
#include <span>
#include <vector>

#include "reconstruct/deposit/detail/region_samples.hpp"

namespace clast::reconstruct_detail {

/// Regions of patches, and what the costs of merging say about them.
struct MergedRegions {
  std::vector<std::uint32_t> region_of_patch;  ///< numbered by their first patch
  /// Lowest cost of merging each region with another, at most 1.
  std::vector<double> lowest_outside;
};

/// Merges patches, the pair with the lowest cost first, until no cost is below a limit. The cost of
/// a pair is the visibility defect of the union near the smaller region plus the mean concavity
/// of the seam between both. It is computed anew before the pair is merged if one of them has
/// grown.
MergedRegions merge_patches(const OrientedPoints& cloud, const ConvexPatches& patches,
                            std::span<const SampledPatch> sampled, unsigned threads);

}  // namespace clast::reconstruct_detail
