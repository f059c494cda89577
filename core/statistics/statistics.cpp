#include "core/statistics/statistics.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>

namespace clast {

SampleSummary summarise_sample(std::span<const double> values) {
  SampleSummary summary;
  summary.count = values.size();
  if (values.empty()) return summary;
  const double count = static_cast<double>(values.size());

  double sum = 0.0;
  for (const double value : values) sum += value;
  summary.mean = sum / count;

  // Second pass about the mean: the one-pass formula loses all digits of map-sized values.
  double squares = 0.0;
  for (const double value : values) squares += (value - summary.mean) * (value - summary.mean);
  summary.std = values.size() > 1 ? std::sqrt(squares / (count - 1.0)) : 0.0;

  std::vector<double> sorted(values.begin(), values.end());
  std::sort(sorted.begin(), sorted.end());
  summary.median = quantile(sorted, 0.5);
  summary.p95 = quantile(sorted, 0.95);
  summary.max = sorted.back();
  return summary;
}

double quantile(std::span<const double> sorted, double p) {
  assert(!sorted.empty() && p >= 0.0 && p <= 1.0);
  const double place = p * static_cast<double>(sorted.size() - 1);
  const std::size_t below = static_cast<std::size_t>(std::floor(place));
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  const double fraction = place - static_cast<double>(below);
  return sorted[below] + fraction * (sorted[above] - sorted[below]);
}

int significant_decimals(const Interval& interval, int max_decimals) {
  int decimals = 0;
  for (double step = 1.0; decimals < max_decimals && !(5.0 * step <= interval.high - interval.low);
       step /= 10.0) {
    ++decimals;
  }
  return decimals;
}

double arithmetic_mean(std::span<const double> values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double upper_median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

Interval wilson_interval(std::size_t hits, std::size_t trials) {
  if (trials == 0) return {};
  const double n = static_cast<double>(trials);
  return wilson_interval_of_proportion(static_cast<double>(hits) / n, n);
}

Interval wilson_interval_of_proportion(double proportion, double trials) {
  assert(proportion >= 0.0 && proportion <= 1.0 && trials > 0.0);
  constexpr double kZ = 1.959963984540054;  // 97.5 % quantile of the standard normal
  const double n = trials;
  const double p = proportion;
  const double shrink = 1.0 + kZ * kZ / n;
  const double middle = (p + kZ * kZ / (2.0 * n)) / shrink;
  const double half = kZ / shrink * std::sqrt(p * (1.0 - p) / n + kZ * kZ / (4.0 * n * n));
  // The bound is exact for proportions of 0 and 1; rounding must not move it beyond them.
  return {p == 0.0 ? 0.0 : std::max(0.0, middle - half),
          p == 1.0 ? 1.0 : std::min(1.0, middle + half)};
}

}  // namespace clast
