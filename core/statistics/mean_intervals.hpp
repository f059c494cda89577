#pragma once
/// Means of independent values, and the difference of two, with intervals of Student's t.
#include <cmath>
#include <optional>

#include "core/statistics/contrast.hpp"
#include "core/statistics/statistics.hpp"

namespace clast {

/// A standard deviation up to this share of the mean is rounding, and the values are equal.
inline constexpr double kRoundingFraction = 1e-9;

/// 95 % interval of the mean: t s/sqrt(n) to either side, with n - 1 degrees of freedom.
/// @return none below two values, or where they are equal, which does not show how they scatter
/// @param possible  that no mean can lie outside of, as 0 to 1 of a share; the interval is cut
/// there
/// @cite student1908
std::optional<Interval> mean_interval(const Summary& values,
                                      const Interval& possible = {-INFINITY, INFINITY});

/// The mean of one group less that of another by Welch's t: each group has a spread of its own, the
/// degrees of freedom are Satterthwaite's.
/// @return the estimate alone below two values of either, or where those of each are equal
/// @cite welch1947 @cite satterthwaite1946
Contrast welch_difference(const Summary& first, const Summary& second);

}  // namespace clast
