#pragma once
/// How large the difference between two groups is, how sure, and how many were looked for.
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/statistics/statistics.hpp"

namespace clast {

/// P-values after Holm's correction for having looked so many times: in ascending order the i-th is
/// multiplied by the number of those not yet passed, and none is below one before it. Below 0.05
/// means that the chance of any false finding among all is below 0.05.
/// @param p_values  in any order; the result is in the same
/// @cite holm1979
std::vector<double> holm(std::span<const double> p_values);

/// Cliff's delta: the chance that a value of `a` is larger than one of `b`, less the chance that it
/// is smaller; from -1 to 1, ties count neither way.
/// @return none when either is empty
/// @cite cliff1993
std::optional<double> cliffs_delta(std::span<const double> a, std::span<const double> b);

/// "negligible", "small", "medium" or "large": the limits 0.147, 0.33 and 0.474.
/// @cite romano2006
const char* words_for_delta(double delta);

/// Hedges' g: the difference of the means in units of the pooled standard deviation, with the
/// factor 1 - 3/(4 (m + n - 2) - 1) that takes its bias away.
/// @return none below two values each, or without any spread
/// @cite hedges1981
std::optional<double> hedges_g(std::span<const double> a, std::span<const double> b);

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
Interval clustered_share_interval(const ClusteredValues& hits, std::size_t clusters);

}  // namespace clast
