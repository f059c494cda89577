#include "classify/size_draws.hpp"

#include <cassert>
#include <cmath>

namespace clast {
namespace {

constexpr double kLimitScore = 1.6448536;  ///< normal quantile of 95 %

/// Returns the size at a normal score: the estimate at 0, the limits of its interval at -1.64 and
/// 1.64.
double size_at_score(double estimate, double lower, double upper, double score) {
  const double limit = score < 0.0 ? lower : upper;
  if (!(limit > 0.0)) return estimate;
  const double ratio = limit / estimate;
  const bool is_outside = score < 0.0 ? ratio > 1.0 : ratio < 1.0;
  if (is_outside) return estimate;
  return estimate * std::pow(ratio, std::abs(score) / kLimitScore);
}

}  // namespace

BlockSizes draw_block_sizes(const MeasuredBlock& block, Random& random) {
  assert(block.deposit);
  const DepositObservation& seen = *block.deposit;
  const double common = std::sqrt(kAxisErrorCorrelation);
  const double own = std::sqrt(1.0 - kAxisErrorCorrelation);
  // Standard deviation of the sum of three scores.
  const double sum_deviation = std::sqrt(3.0 + 6.0 * kAxisErrorCorrelation);
  const double shared = common * random.normal();
  const double l = shared + own * random.normal();
  const double i = shared + own * random.normal();
  const double s = shared + own * random.normal();
  BlockSizes sizes;
  sizes.axes = Axes::sorted(size_at_score(block.axes.L, seen.lower_axes.L, seen.upper_axes.L, l),
                            size_at_score(block.axes.I, seen.lower_axes.I, seen.upper_axes.I, i),
                            size_at_score(block.axes.S, seen.lower_axes.S, seen.upper_axes.S, s));
  sizes.volume =
      size_at_score(seen.volume, seen.lower_volume, seen.upper_volume, (l + i + s) / sum_deviation);
  return sizes;
}

}  // namespace clast
