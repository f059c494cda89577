#pragma once
/// Difference in mean of two groups of values that depend on both block and release point, with
/// equivalence test, power and sample size.
#include <cstdint>
#include <optional>
#include <vector>

#include "core/statistics/contrast.hpp"

namespace clast {

/// Sample of two groups. Each value belongs to a unit (block) and a point (release point).
struct CrossedSample {
  std::vector<double> values;
  std::vector<bool> in_second_group;  ///< per value: true for the second group
  std::vector<std::uint32_t> units;   ///< one per value
  std::vector<std::uint32_t> points;  ///< one per value
  /// Stratum of each value. Only values of the same stratum are compared.
  std::vector<std::uint32_t> strata;
};

/// Mean of the second group minus mean of the first. Without scatter, the standard error is zero.
struct CrossedDifference : Contrast {
  double scatter = 0.0;  ///< standard deviation of values within group and stratum
  /// Variance of the difference divided by its variance for independent values.
  double design_effect = 1.0;
};

/// Computes the difference of two groups by least squares, with one mean per stratum. Values may be
/// dependent within units and within points. The variance is U + P - B, but at least U and P. U is
/// the variance clustered by units, P by points, and B by pairs of unit and point. Degrees of
/// freedom follow Satterthwaite's formula; interval and p-value are by Student's t.
/// @return empty if no stratum has both groups, if there are fewer than two units, or if no unit is
///         in both groups and a group has fewer than two units
/// @throws InputError  if list lengths differ
/// @cite cameron2011 @cite satterthwaite1946
std::optional<CrossedDifference> crossed_difference(const CrossedSample& sample);

/// Returns the p-value of two one-sided equivalence tests. If it is below 0.05, the difference is
/// within the margin at the 5 % level.
/// @param margin  positive
/// @cite schuirmann1987
double equivalence_p_value(const Contrast& contrast, double margin);

inline constexpr double kDefaultPower = 0.8;

/// Power of a two-sided test at 5 % for a true difference, from the non-central t distribution.
/// @param standard_error  positive
double test_power(double difference, double standard_error, double degrees_of_freedom);
/// Returns the minimum detectable difference at power `kDefaultPower`.
/// @return detectable difference; zero if the standard error is zero
double minimum_detectable_difference(double standard_error, double degrees_of_freedom);

/// Returns the total sample size, half of it per group, to detect a difference x at power
/// `kDefaultPower`: 4 D s^2 (z_0.975 + z_0.8)^2 / x^2, with normal quantiles z.
/// @param difference  x, not zero
/// @param scatter  standard deviation s of the values
/// @param design_effect  D
double required_sample_size(double difference, double scatter, double design_effect);

}  // namespace clast
