#pragma once
/// Runs by draw of uncertain ground, and the range of an outcome over the draws.
#include <cstdint>
#include <vector>

#include "study/compare/comparison.hpp"

namespace clast {

/// Runs of one member of the ensemble of a file.
struct GroundDrawRows {
  std::uint32_t file = 0;
  std::uint32_t member = 0;
  std::vector<std::size_t> rows;  ///< into Comparison::rows
};

/// By file, then member. Empty where no run is of a file whose ground is drawn more than once.
std::vector<GroundDrawRows> group_rows_by_draw(const Comparison& comparison,
                                     const std::vector<std::size_t>& rows);

/// From so many draws on, a range leaves out one draw of ten.
inline constexpr std::size_t kDrawsForTenths = 20;

/// The range of a value over draws: nine draws of ten lie in it (the 5th to the 95th percentile),
/// below `kDrawsForTenths` all of them.
/// @param values  of each draw, at least one
Interval range_of_draw_means(std::vector<double> values);

}  // namespace clast
