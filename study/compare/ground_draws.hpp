#pragma once
/// Grouping of runs by ground draw (ensemble member), and ranges over the draws.
#include <cstdint>
#include <vector>

#include "study/compare/comparison.hpp"

namespace clast {

/// Runs of one ensemble member of a file.
struct GroundDrawRows {
  std::uint32_t file = 0;
  std::uint32_t member = 0;
  std::vector<std::size_t> rows;  ///< indices into Comparison::rows
};

/// Groups rows by file, then ensemble member. Empty if no file has more than one ground draw.
std::vector<GroundDrawRows> group_rows_by_draw(const Comparison& comparison,
                                               const std::vector<std::size_t>& rows);

/// Minimum number of draws for which percentiles are given as range.
inline constexpr std::size_t kMinDrawsForPercentiles = 20;

/// Returns the 5th and 95th percentile of values over ground draws, or their minimum and maximum if
/// there are fewer than `kMinDrawsForPercentiles`.
/// @param values  one per draw, not empty
Interval compute_range_over_draws(std::vector<double> values);

}  // namespace clast
