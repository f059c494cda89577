#pragma once
/// Intervals of means, of differences of means and of shares whose values come in clusters.
#include <cstdint>
#include <optional>
#include <vector>

#include "core/statistics/statistics.hpp"

namespace clast {

/// What 95 % of the values lie in, as many below as above.
/// @param values  not empty, in any order
Interval percentile_interval(std::vector<double> values);

/// Values of which those of one cluster have something in common.
struct ClusteredValues {
  std::vector<double> values;
  std::vector<std::uint32_t> clusters;  ///< of each value, below the number of clusters
};

/// 95 % interval of mean(a) - mean(b) by the percentiles of a bootstrap that draws whole clusters
/// with replacement, the same for both groups. With one cluster values are drawn instead.
/// @param clusters  how many there are
/// @param draws     positive
/// @return none when either group is empty, or when hardly a draw has values of both
/// @cite field2007
std::optional<Interval> bootstrap_difference(const ClusteredValues& a, const ClusteredValues& b,
                                             std::size_t clusters, std::uint64_t seed,
                                             std::size_t draws = 2000);

/// 95 % interval of the mean of `values`, by the same bootstrap.
/// @return none when there are no values
/// @cite field2007
std::optional<Interval> bootstrap_mean(const ClusteredValues& values, std::size_t clusters,
                                       std::uint64_t seed, std::size_t draws = 2000);

/// 95 % interval of a share whose trials come in clusters: Wilson's, for as many independent trials
/// as would make the share vary as it does between clusters, and for no more than there are. Trials
/// count as independent where all are of one cluster, and where the share is 0 or 1.
/// @param hits  1 where it happened, else 0
/// @return [0, 1] when there was no trial
/// @cite wilson1927, korn1998
Interval clustered_proportion_interval(const ClusteredValues& hits, std::size_t clusters);

}  // namespace clast
