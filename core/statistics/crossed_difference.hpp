#pragma once
/// The difference of two groups whose values come in two kinds of clusters, crossed with each
/// other; whether it is too small to matter; and how many values it takes to find one.
#include <cstdint>
#include <optional>
#include <vector>

#include "core/statistics/contrast.hpp"

namespace clast {

/// Values of units (blocks) from points (release points).
struct CrossedSample {
  std::vector<double> values;
  std::vector<bool> high;             ///< of each value: whether it is of the second group
  std::vector<std::uint32_t> units;   ///< of each value
  std::vector<std::uint32_t> points;  ///< of each value
  /// Of each value: only values with the same number are compared with each other.
  std::vector<std::uint32_t> strata;
};

/// Mean of the second group less that of the first; its standard error is zero where nothing
/// scatters.
struct CrossedDifference : Contrast {
  double scatter = 0.0;  ///< standard deviation of a value within group and stratum
  /// How many times as large the variance of the difference is as that of independent values.
  double design_effect = 1.0;
};

/// The difference within strata, as the least-squares fit of a mean for each stratum and one
/// difference gives it, weighted as the values come. Its variance is that of two-way clustering:
/// of sums over units, plus of sums over points, less of sums over values that share both, and no
/// less than the larger of the first two. Each has its degrees of freedom, those of the
/// combination are Satterthwaite's, and the interval and p are of Student's t.
/// @return none where no stratum has both groups, or where fewer than two units are in each group
///         and no unit is in both, or with fewer than two units
/// @throws InputError  lists of different lengths
/// @cite cameron2011 @cite satterthwaite1946
std::optional<CrossedDifference> crossed_difference(const CrossedSample& sample);

/// Two one-sided tests: the probability of a difference so near to zero if the true one were as
/// large as `margin`, in either direction. Below 0.05 the difference is within the margin, at the
/// level of 5 %.
/// @param margin  positive
/// @cite schuirmann1987
double equivalence_p_value(const Contrast& contrast, double margin);

inline constexpr double kDefaultPower = 0.8;

/// The chance that a true difference is called one, two-sided at 5 %: of the non-central t.
/// @param standard_error  positive
double test_power(double difference, double standard_error, double degrees_of_freedom);
/// The difference that is found with the probability `kDefaultPower`.
/// @return zero where the standard error is
double minimum_detectable_difference(double standard_error, double degrees_of_freedom);

/// Values in all, half of each group, of which a difference is found with the probability
/// `kDefaultPower`: 4 D s^2 (z_0.975 + z_0.8)^2 / x^2.
/// @param difference     x, not zero
/// @param scatter        s
/// @param design_effect  D
double required_sample_size(double difference, double scatter, double design_effect);

}  // namespace clast
