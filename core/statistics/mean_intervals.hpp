#pragma once
/// Confidence intervals of means and of differences of means by Student's t.
#include <cmath>
#include <optional>

#include "core/statistics/contrast.hpp"
#include "core/statistics/statistics.hpp"

namespace clast {

/// Largest ratio of standard deviation to mean that is treated as a rounding error.
inline constexpr double kRoundingFraction = 1e-9;

/// Returns the 95 % interval of the mean: mean +- t s/sqrt(n), with sample standard deviation s and
/// n - 1 degrees of freedom.
/// @return interval; empty if there are fewer than two values, or if all are equal
/// @param possible_range  range of possible means, to which the interval is clipped
/// @cite student1908
std::optional<Interval> mean_interval(const SampleSummary& values,
                                      const Interval& possible_range = {-INFINITY, INFINITY});

/// Computes the difference of two means by Welch's t-test with Satterthwaite's degrees of freedom.
/// @return contrast; only its estimate is set if a group has fewer than two values, or if all
///         values in each group are equal
/// @cite welch1947 @cite satterthwaite1946
Contrast welch_difference(const SampleSummary& first, const SampleSummary& second);

}  // namespace clast
