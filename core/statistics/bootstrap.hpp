#pragma once
/// Confidence intervals of means, differences of means and proportions of clustered values.
#include <cstdint>
#include <optional>
#include <vector>

#include "core/statistics/statistics.hpp"

namespace clast {

/// Returns the interval from the 2.5th to the 97.5th percentile of the values.
/// @param values  not empty, in any order
Interval percentile_interval(std::vector<double> values);

/// Values that may be dependent within clusters, with the cluster of each value.
struct ClusteredValues {
  std::vector<double> values;
  std::vector<std::uint32_t> clusters;  ///< one per value, below the number of clusters
};

/// Returns the 95 % percentile interval of mean(a) - mean(b) by a bootstrap of whole clusters. The
/// same clusters are drawn for both groups. If there is only one cluster, single values are drawn.
/// @param cluster_count  number of clusters
/// @param draws  number of bootstrap draws, positive
/// @return interval; empty if a group is empty or if nearly no draw has values of both groups
/// @cite field2007
std::optional<Interval> bootstrap_difference_interval(const ClusteredValues& a,
                                                      const ClusteredValues& b,
                                                      std::size_t cluster_count, std::uint64_t seed,
                                                      std::size_t draws = 2000);

/// Returns the 95 % interval of the mean of clustered values, by a bootstrap of whole clusters.
/// @return interval; empty if there are no values
/// @cite field2007
std::optional<Interval> bootstrap_mean_interval(const ClusteredValues& values,
                                                std::size_t cluster_count, std::uint64_t seed,
                                                std::size_t draws = 2000);

/// Returns the 95 % interval of a proportion of clustered trials. It is Wilson's interval for the
/// effective number of trials: the number of independent trials that gives the observed variance
/// between clusters, at most the actual number. Trials count as independent if there is only one
/// cluster or if the proportion is 0 or 1.
/// @param hits  1 for success, 0 otherwise
/// @return interval; [0, 1] if there are no trials
/// @cite wilson1927, korn1998
Interval clustered_proportion_interval(const ClusteredValues& hits, std::size_t cluster_count);

}  // namespace clast
