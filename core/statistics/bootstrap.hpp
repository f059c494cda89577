#pragma once
/// Confidence intervals of means, differences of means and proportions of clustered values.
#include <cstdint>
#include <optional>
#include <vector>

#include "core/statistics/statistics.hpp"

namespace clast {

/// Returns the interval from the 2.5th to the 97.5th percentile.
/// @param values  not empty, in any order
Interval percentile_interval(std::vector<double> values);

struct ClusteredValues {
  std::vector<double> values;
  std::vector<std::uint32_t> clusters;  ///< one per value, below the number of clusters
};

/// Returns the 95 % percentile interval of mean(a) - mean(b) from a bootstrap of whole clusters,
/// drawn jointly for both groups. With one cluster, single values are drawn.
/// @param clusters  number of clusters
/// @param draws  positive
/// @return empty if a group is empty, or nearly no draw has values of both
/// @cite field2007
std::optional<Interval> bootstrap_difference(const ClusteredValues& a, const ClusteredValues& b,
                                             std::size_t clusters, std::uint64_t seed,
                                             std::size_t draws = 2000);

/// Returns the 95 % interval of the mean of clustered values, from the same bootstrap.
/// @return empty if there are no values
/// @cite field2007
std::optional<Interval> bootstrap_mean(const ClusteredValues& values, std::size_t clusters,
                                       std::uint64_t seed, std::size_t draws = 2000);

/// Returns the 95 % interval of a proportion of clustered trials: Wilson's interval for the
/// effective number of independent trials that gives the observed variance between clusters, at
/// most the actual number. Trials count as independent if there is a single cluster or the
/// proportion is 0 or 1.
/// @param hits  1 for success, 0 otherwise
/// @return [0, 1] without trials
/// @cite wilson1927, korn1998
Interval clustered_proportion_interval(const ClusteredValues& hits, std::size_t clusters);

}  // namespace clast
