#pragma once
/// Difference of two groups with two crossed kinds of clusters, equivalence test, power and sample
/// size.
#include <cstdint>
#include <optional>
#include <vector>

#include "core/statistics/contrast.hpp"

namespace clast {

/// Values of units (blocks) from points (release points).
struct CrossedSample {
  std::vector<double> values;
  std::vector<bool> high;             ///< per value: true for the second group
  std::vector<std::uint32_t> units;   ///< one per value
  std::vector<std::uint32_t> points;  ///< one per value
  /// Stratum of each value; only values of one stratum are compared.
  std::vector<std::uint32_t> strata;
};

/// Mean of the second group minus mean of the first; the standard error is zero without scatter.
struct CrossedDifference : Contrast {
  double scatter = 0.0;  ///< standard deviation of values within group and stratum
  /// Variance of the difference over that of independent values.
  double design_effect = 1.0;
};

/// Computes the difference within strata by least squares with a mean per stratum and one
/// difference. The variance uses two-way clustering: sums over units plus sums over points minus
/// sums over pairs, at least the larger of the first two. Degrees of freedom are combined by
/// Satterthwaite's formula; interval and p-value are Student's t.
/// @return empty if no stratum has both groups, fewer than two units are in each group and none in
///          both, or there are fewer than two units
/// @throws InputError  if list lengths differ
/// @cite cameron2011 @cite satterthwaite1946
std::optional<CrossedDifference> crossed_difference(const CrossedSample& sample);

/// Returns the p-value of two one-sided equivalence tests. Below 0.05 the difference is within the
/// margin at the 5 % level.
/// @param margin  positive
/// @cite schuirmann1987
double equivalence_p_value(const Contrast& contrast, double margin);

/// Default statistical power.
inline constexpr double kDefaultPower = 0.8;

/// Returns the power of a two-sided test at 5 % for a true difference, from the non-central t
/// distribution.
/// @param standard_error  positive
double test_power(double difference, double standard_error, double degrees_of_freedom);
/// Returns the minimum detectable difference at power `kDefaultPower`.
/// @return zero if the standard error is zero
double minimum_detectable_difference(double standard_error, double degrees_of_freedom);

/// Returns the total sample size, half per group, to detect a difference at power `kDefaultPower`:
/// 4 D s^2 (z_0.975 + z_0.8)^2 / x^2.
/// @param difference  x, not zero
/// @param scatter  s
/// @param design_effect  D
double required_sample_size(double difference, double scatter, double design_effect);

}  // namespace clast
