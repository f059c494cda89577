#pragma once
/// Differences between groups of runs: how large, how sure.
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/statistics/contrast.hpp"

namespace clast {

struct Comparison;

/// Two groups of one kind in one quantity: first mean less second mean. The test is that of
/// Kolmogorov and Smirnov, clusters kept (clustered_ks_test); there is none where a group is of one
/// realisation. It is corrected for all differences of the same kind of group.
struct Difference : Contrast {
  std::size_t first = 0;  ///< index into Comparison::groups
  std::size_t second = 0;
  std::string quantity;        ///< "runout_m", "EC11 speed_m_s"
  std::size_t first_runs = 0;  ///< with the quantity
  std::size_t second_runs = 0;
  std::size_t points = 0;  ///< clusters of interval and test that either has: release points,
                           ///< or realisations where blocks stay
  double first_mean = 0.0;
  double second_mean = 0.0;
  double cliffs_delta = 0.0;  ///< first against second
  std::optional<double> hedges_g;
  double ks_distance = 0.0;
};

/// Groups of one kind beyond this are not compared pair by pair.
inline constexpr std::size_t kMostGroups = 12;

/// All pairs of blocks, of classes and of the groups of every column, over all files. Of each pair:
/// runout, lateral angle and path length of the runs that came to rest, largest speed of all that
/// did not fail, and speed, energy and height at first crossings of every barrier. Pairs of which a
/// group has fewer than three values are left out.
std::vector<Difference> differences(const Comparison& comparison);

/// The runouts of any two groups, alone: `p_holm` is `p_value`.
/// @return none where a group has fewer than three runs at rest
std::optional<Difference> compute_runout_difference(const Comparison& comparison, std::size_t first,
                                            std::size_t second);

}  // namespace clast
