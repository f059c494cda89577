#pragma once
/// Pairwise differences between groups of runs, with confidence intervals and tests.
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/statistics/contrast.hpp"

namespace clast {

struct Comparison;

/// Difference between two groups of runs in one quantity: first mean minus second mean, with a
/// clustered Kolmogorov-Smirnov test. The p-value is corrected for the number of tests.
struct GroupDifference : Contrast {
  std::size_t first = 0;  ///< index into Comparison::groups
  std::size_t second = 0;
  std::string quantity;        ///< name of the quantity, such as "runout_m"
  std::size_t first_runs = 0;  ///< number of runs with the quantity
  std::size_t second_runs = 0;
  std::size_t points = 0;  ///< number of clusters of dependent runs: release points or realisations
  double first_mean = 0.0;
  double second_mean = 0.0;
  double cliffs_delta = 0.0;  ///< Cliff's delta of the first group against the second
  std::optional<double> hedges_g;
  double ks_distance = 0.0;
};

/// Maximum number of groups of one kind that are compared pairwise.
inline constexpr std::size_t kMaxComparedGroups = 12;

/// Computes the differences of all pairs of blocks, of classes and of column groups, in runout,
/// lateral angle, path length, largest speed, and in speed, energy and height at each barrier.
/// Pairs with fewer than three values in a group are omitted.
std::vector<GroupDifference> compute_differences(const Comparison& comparison);

/// Computes the runout difference of two groups as a single test.
/// @return empty if a group has fewer than three runs at rest
std::optional<GroupDifference> compute_runout_difference(const Comparison& comparison,
                                                         std::size_t first, std::size_t second);

}  // namespace clast
