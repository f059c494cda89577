#include "samples/deposit/interval_score.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/statistics/statistics.hpp"

namespace clast {
namespace {

struct JudgedRange {
  double truth, low, high;
};

double median_of(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values.empty() ? 0.0 : quantile(values, 0.5);
}

RangeScore score_ranges(std::span<const JudgedRange> ranges) {
  RangeScore score;
  score.count = ranges.size();
  if (ranges.empty()) return score;
  std::vector<double> widths, scores;
  std::size_t covered = 0;
  for (const auto& [truth, low, high] : ranges) {
    if (low <= truth && truth <= high) ++covered;
    widths.push_back((high - low) / truth);
    scores.push_back(interval_score(low, high, truth, kIntervalLevel) / truth);
  }
  score.coverage = static_cast<double>(covered) / static_cast<double>(ranges.size());
  // Not between two values, so that unbounded ones do not make the median undefined.
  score.median_width = upper_median(widths);
  score.mean_score = arithmetic_mean(scores);
  return score;
}

std::optional<ConstantFactorInterval> best_constant_factors(
    std::span<const JudgedEstimate> estimates) {
  std::vector<double> ratios;
  std::size_t covered = 0;
  for (const auto& [truth, estimate] : estimates) {
    ratios.push_back(truth / estimate.value);
    if (estimate.low90 <= truth && truth <= estimate.high90) ++covered;
  }
  if (covered == 0) return {};
  std::sort(ratios.begin(), ratios.end());
  std::optional<ConstantFactorInterval> best;
  for (std::size_t i = 0; i + covered <= ratios.size(); ++i) {
    ConstantFactorInterval candidate{ratios[i], ratios[i + covered - 1], {}};
    std::vector<JudgedRange> ranges;
    for (const auto& [truth, estimate] : estimates) {
      // A bound that is the truth itself contains it, whatever the rounding.
      const double ratio = truth / estimate.value;
      const double low =
          ratio == candidate.low_factor ? truth : candidate.low_factor * estimate.value;
      const double high =
          ratio == candidate.high_factor ? truth : candidate.high_factor * estimate.value;
      ranges.push_back({truth, low, high});
    }
    candidate.score = score_ranges(ranges);
    if (!best || candidate.score.mean_score < best->score.mean_score) best = candidate;
  }
  return best;
}

}  // namespace

double interval_score(double low, double high, double truth, double level) {
  const double outside = std::max({0.0, low - truth, truth - high});
  return high - low + 2.0 / (1.0 - level) * outside;
}

EstimateScore score_estimates(std::span<const JudgedEstimate> estimates) {
  EstimateScore score;
  std::vector<double> errors, absolute_errors;
  std::vector<JudgedRange> bounds, intervals;
  std::vector<JudgedEstimate> with_interval;
  for (const auto& [truth, estimate] : estimates) {
    if (!std::isnan(estimate.value)) {
      errors.push_back(estimate.value / truth - 1.0);
      absolute_errors.push_back(std::abs(errors.back()));
    }
    if (!std::isnan(estimate.low) && !std::isnan(estimate.high)) {
      bounds.push_back({truth, estimate.low, estimate.high});
    }
    if (std::isnan(estimate.low90) || std::isnan(estimate.high90)) continue;
    intervals.push_back({truth, estimate.low90, estimate.high90});
    if (estimate.value > 0.0) with_interval.push_back({truth, estimate});
  }
  score.count = errors.size();
  score.median_absolute_error = median_of(absolute_errors);
  score.bias = median_of(errors);
  score.bounds = score_ranges(bounds);
  score.intervals = score_ranges(intervals);
  score.constant_factor = best_constant_factors(with_interval);
  return score;
}

}  // namespace clast
