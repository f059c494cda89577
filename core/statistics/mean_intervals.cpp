#include "core/statistics/mean_intervals.hpp"

#include <algorithm>
#include <cmath>

#include "core/statistics/probability.hpp"

namespace clast {
namespace {

constexpr double kUpper = 0.975;  ///< a two-sided interval of 95 % ends there

/// Variance of the mean; zero where all values are equal.
double mean_variance(const Summary& values) {
  if (!(values.std > kRoundingShare * std::abs(values.mean))) return 0.0;
  return values.std * values.std / static_cast<double>(values.count);
}

Interval around(double value, double half_width) {
  return {value - half_width, value + half_width};
}

}  // namespace

std::optional<Interval> mean_interval(const Summary& values, const Interval& possible) {
  if (values.count < 2) return std::nullopt;
  const double variance = mean_variance(values);
  if (!(variance > 0.0)) return std::nullopt;
  const double t = student_quantile(kUpper, static_cast<double>(values.count - 1));
  const Interval interval = around(values.mean, t * std::sqrt(variance));
  return Interval{std::max(interval.low, possible.low), std::min(interval.high, possible.high)};
}

std::optional<MeanDifference> welch_difference(const Summary& first, const Summary& second) {
  if (first.count < 2 || second.count < 2) return std::nullopt;
  const double a = mean_variance(first), b = mean_variance(second), both = a + b;
  if (!(both > 0.0)) return std::nullopt;
  MeanDifference found;
  found.difference = first.mean - second.mean;
  found.standard_error = std::sqrt(both);
  // As shares of their sum, so that small variances do not vanish when squared.
  const double of_a = a / both, of_b = b / both;
  found.freedom = 1.0 / (of_a * of_a / static_cast<double>(first.count - 1) +
                         of_b * of_b / static_cast<double>(second.count - 1));
  found.interval =
      around(found.difference, student_quantile(kUpper, found.freedom) * found.standard_error);
  found.p_value = student_beyond(found.difference / found.standard_error, found.freedom);
  return found;
}

}  // namespace clast
