#pragma once
/// Random draws of the possible true sizes of a partly hidden block.
#include "classify/measured_block.hpp"
#include "core/random.hpp"

namespace clast {

struct BlockSizes {
  Axes axes;            ///< L >= I >= S, m
  double volume = 0.0;  ///< m^3
};

/// Returns the sizes that a block of a deposit exceeds with a probability of one half: the
/// geometric means of the limits of its 90 % intervals, or the estimates where there are none.
/// @param block  with an observation (`MeasuredBlock::deposit`)
BlockSizes median_block_sizes(const MeasuredBlock& block);

/// Draws sizes that a block of a deposit may have, given its 90 % intervals.
///
/// The logarithm of each size is normal, with the limits of the interval at the quantiles 5 and
/// 95 %. The errors of L, I and S are correlated (`kAxisErrorCorrelation`), and that of the volume
/// is proportional to their sum. The drawn lengths are sorted, as the sides of a box are.
/// @param block  with an observation (`MeasuredBlock::deposit`)
BlockSizes draw_block_sizes(const MeasuredBlock& block, Random& random);

/// Correlation of the errors of two axes of a block in virtual deposits (docs/theory/deposits.md).
inline constexpr double kAxisErrorCorrelation = 0.1;

}  // namespace clast
