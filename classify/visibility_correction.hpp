#pragma once
/// Probability that a block of a deposit is found in a scan of its surface, by its size.
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "classify/measured_block.hpp"

namespace clast {

/// Distribution of the visible area of blocks over I^2: normal, with a mean that is linear in ln I.
/// Negative areas are those of blocks that are wholly hidden.
struct VisibleAreaModel {
  double mean = 0.0;       ///< at I = `VisibilityCorrection::middle_size`
  double slope = 0.0;      ///< change of the mean with ln I
  double deviation = 1.0;  ///< standard deviation, positive
};

/// Correction for the blocks that a scan of the surface does not show.
///
/// A block is found if its visible area has enough points and is a large enough fraction of its
/// surface. Visible areas of blocks below this limit are missing in the scan, so their distribution
/// follows from that of the found blocks by truncated regression. A found block stands for 1 over
/// the probability that a block of its size is found (Horvitz and Thompson). Derivation and
/// assumptions are in docs/theory/deposits.md.
/// @cite horvitz1952 @cite hausman1977
struct VisibilityCorrection {
  /// Fraction of the blocks with enough visible area that are found (docs/theory/deposits.md).
  static constexpr double kMostFound = 0.95;
  /// Number of points with which half of the blocks are found (docs/theory/deposits.md), and the
  /// least visible fraction of a block that is found, as in reconstruct/deposit.
  static constexpr std::size_t kLeastPoints = 150;
  static constexpr double kLeastVisibleFraction = 0.12;
  /// Least probability: no block stands for more than ten of its size.
  static constexpr double kLeastProbability = 0.1;

  VisibleAreaModel model;
  double middle_size = 1.0;             ///< geometric mean of the I of the found blocks, m
  double surface_ratio = 0.0;           ///< area of the surface of a block over I^2, median
  std::vector<double> spacings;         ///< quantiles of the point spacing, m
  std::vector<VisibleAreaModel> draws;  ///< models that are as probable as their number says

  /// Returns the probability that a block of the deposit is found.
  /// @param intermediate  I, m, positive
  double inclusion_probability(double intermediate) const;
  /// Returns the correction by one of `draws`, which must not be empty.
  VisibilityCorrection with_draw(std::size_t index) const;
};

/// Least number of blocks for which a correction is estimated.
inline constexpr std::size_t kLeastCorrectedBlocks = 3;

/// Estimates the correction from the found blocks of a deposit.
/// @param blocks  not empty; all with an observation
/// @param draws  number of draws of the model, positive
VisibilityCorrection fit_visibility_correction(std::span<const MeasuredBlock> blocks,
                                               std::uint64_t seed, std::size_t draws = 400);

}  // namespace clast
