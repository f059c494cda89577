#pragma once
/// Distinction of blocks from ground and fines.
#include <cstdint>
#include <span>
#include <vector>

#include "reconstruct/deposit/detail/region_samples.hpp"

namespace clast::reconstruct_detail {

/// Measures of a region by which blocks differ from ground.
struct RegionMeasures {
  std::size_t points = 0;
  /// Mean sine by which its points lie below the tangent planes of each other: 0 for flat ground,
  /// 0.5 for a sphere.
  double self_convexity = 0.0;
  /// Mean of 1 - cos of the angle between the normals on both sides of its border.
  double border_bend = 0.0;
  /// Visibility defect of its points with those of other regions around it.
  double outer_defect = 0.0;
  /// Extent along the mean of its normals, in point spacings.
  double relief = 0.0;

  /// Logarithm of the odds that the region is a block rather than ground, by logistic regression on
  /// virtual deposits.
  double block_log_odds() const;
  bool is_block() const;
  /// Probability that the region is one block: that the intersection over union of its points and
  /// those of a true block exceeds 0.5, by logistic regression on virtual deposits.
  /// @param lowest_cost  lowest cost of merging it with another region
  double block_probability(double lowest_cost) const;
};

/// Measures regions.
/// @param region_of_patch  region of each patch, numbered from 0
std::vector<RegionMeasures> measure_regions(const OrientedPoints& cloud,
                                            const ConvexPatches& patches,
                                            std::span<const SampledPatch> sampled,
                                            std::span<const std::uint32_t> region_of_patch,
                                            unsigned threads);

/// Adds to each block the pockets of ground that it encloses: connected points with label 0 that
/// have no neighbours of other blocks, and at most 2 % of the points of the block.
/// @param labels  block of each point; 0: ground
void fill_enclosed_ground(const OrientedPoints& cloud, std::vector<std::uint32_t>& labels);

/// Reassigns points near borders of regions to the region whose tangent planes they fit best, and
/// smooths the labels by a majority vote.
/// @param labels  region of each point
void refine_borders(const OrientedPoints& cloud, std::vector<std::uint32_t>& labels,
                    unsigned threads);

}  // namespace clast::reconstruct_detail
