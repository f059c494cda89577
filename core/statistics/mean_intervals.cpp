#include "core/statistics/mean_intervals.hpp"

#include <algorithm>
#include <cmath>

#include "core/statistics/probability.hpp"

namespace clast {
namespace {

constexpr double kUpper = 0.975;  ///< a two-sided interval of 95 % ends there

/// Variance of the mean; zero where all values are equal.
double mean_variance(const SampleSummary& values) {
  if (!(values.std > kRoundingFraction * std::abs(values.mean))) return 0.0;
  return values.std * values.std / static_cast<double>(values.count);
}

}  // namespace

std::optional<Interval> mean_interval(const SampleSummary& values, const Interval& possible_range) {
  if (values.count < 2) return std::nullopt;
  const double variance = mean_variance(values);
  if (!(variance > 0.0)) return std::nullopt;
  const double t = student_quantile(kUpper, static_cast<double>(values.count - 1));
  const double half = t * std::sqrt(variance);
  return Interval{std::max(values.mean - half, possible_range.low),
                  std::min(values.mean + half, possible_range.high)};
}

Contrast welch_difference(const SampleSummary& first, const SampleSummary& second) {
  Contrast found;
  found.estimate = first.mean - second.mean;
  if (first.count < 2 || second.count < 2) return found;
  const double a = mean_variance(first), b = mean_variance(second), both = a + b;
  if (!(both > 0.0)) return found;
  // Variances are divided by their sum, so that small ones do not underflow when squared.
  const double of_a = a / both, of_b = b / both;
  const double degrees_of_freedom = 1.0 / (of_a * of_a / static_cast<double>(first.count - 1) +
                                           of_b * of_b / static_cast<double>(second.count - 1));
  return student_contrast(found.estimate, std::sqrt(both), degrees_of_freedom);
}

}  // namespace clast
