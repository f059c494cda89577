#pragma once
/// Confidence intervals of means and of differences of means by Student's t.
#include <cmath>
#include <optional>

#include "core/statistics/contrast.hpp"
#include "core/statistics/statistics.hpp"

namespace clast {

/// Maximum relative standard deviation due to rounding; values are then equal.
inline constexpr double kRoundingFraction = 1e-9;

/// Returns the 95 % interval of the mean: t s/sqrt(n) to either side, with n - 1 degrees of
/// freedom.
/// @return empty below two values, or if all values are equal, so that their scatter is unknown
/// @param possible  range of possible means, to which the interval is clipped
/// @cite student1908
std::optional<Interval> mean_interval(const Summary& values,
                                      const Interval& possible = {-INFINITY, INFINITY});

/// Computes the difference of two means by Welch's t-test with Satterthwaite's degrees of freedom.
/// @return the estimate only, if a group has fewer than two values or all values of each are equal
/// @cite welch1947 @cite satterthwaite1946
Contrast welch_difference(const Summary& first, const Summary& second);

}  // namespace clast
