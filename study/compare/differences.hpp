#pragma once
/// Pairwise differences between groups of runs, with confidence intervals and tests.
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/statistics/contrast.hpp"

namespace clast {

struct Comparison;

/// Difference of two groups of one kind in one quantity: first mean minus second mean. It is tested
/// by a clustered Kolmogorov-Smirnov test (`clustered_ks_test`). The p-value is corrected for the
/// number of differences between groups of that kind. No test if a group is a single realisation.
struct GroupDifference : Contrast {
  std::size_t first = 0;  ///< index into Comparison::groups
  std::size_t second = 0;
  std::string quantity;        ///< "runout_m", "EC11 speed_m_s"
  std::size_t first_runs = 0;  ///< number of runs with the quantity
  std::size_t second_runs = 0;
  std::size_t points =
      0;  ///< number of clusters: release points, or realisations if blocks are persistent
  double first_mean = 0.0;
  double second_mean = 0.0;
  double cliffs_delta = 0.0;  ///< Cliff's delta of the first group against the second
  std::optional<double> hedges_g;
  double ks_distance = 0.0;
};

/// Maximum number of groups of one kind that are compared pairwise.
inline constexpr std::size_t kMaxComparedGroups = 12;

/// Computes the differences of all pairs of blocks, of classes and of column groups, over all
/// files. The quantities are the runout, lateral angle and path length of runs at rest, the largest
/// speed of runs without error, and the speed, energy and height at the counted crossing of each
/// barrier. Pairs with fewer than three values in a group are omitted.
std::vector<GroupDifference> compute_differences(const Comparison& comparison);

/// Computes the runout difference of two groups as a single test (`p_holm` equals `p_value`).
/// @return empty if a group has fewer than three runs at rest
std::optional<GroupDifference> compute_runout_difference(const Comparison& comparison,
                                                         std::size_t first, std::size_t second);

}  // namespace clast
