#pragma once
/// Grouping of runs by ensemble member. Each member has its own draw of the ground parameters.
#include <cstdint>
#include <vector>

#include "study/compare/comparison.hpp"

namespace clast {

/// Runs of one ensemble member, which share a draw of the ground parameters.
struct GroundDrawRows {
  std::uint32_t file = 0;
  std::uint32_t member = 0;
  std::vector<std::size_t> rows;  ///< indices into Comparison::rows
};

/// Groups runs by file, then ensemble member. Empty if no file has several members.
std::vector<GroundDrawRows> group_rows_by_draw(const Comparison& comparison,
                                               const std::vector<std::size_t>& rows);

/// Minimum number of ensemble members for which ranges are percentiles instead of minimum and
/// maximum.
inline constexpr std::size_t kMinDrawsForPercentiles = 20;

/// Computes the range of values over ensemble members: 5th and 95th percentile, or minimum and
/// maximum if there are fewer than `kMinDrawsForPercentiles`.
/// @param values  one value per member, not empty
Interval compute_range_over_draws(std::vector<double> values);

}  // namespace clast
