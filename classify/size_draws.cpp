#include "classify/size_draws.hpp"

#include <array>
#include <cassert>
#include <cmath>

namespace clast {
namespace {

constexpr double kLimitScore = 1.6448536;  ///< normal quantile of 95 %

/// Distribution of the logarithm of a size of which the 90 % interval is known.
struct LogSize {
  double median = 0.0;  ///< of the size
  double deviation = 0.0;

  LogSize(double estimate, double lower, double upper) : median(estimate) {
    if (!(lower > 0.0) || !(upper > lower)) return;
    median = std::sqrt(lower * upper);
    deviation = 0.5 * std::log(upper / lower) / kLimitScore;
  }
  double at(double score) const { return median * std::exp(deviation * score); }
};

/// Returns the sizes at normal scores of L, I, S and the volume.
BlockSizes sizes_at(const MeasuredBlock& block, const std::array<double, 4>& scores) {
  assert(block.deposit);
  const Axes &axes = block.axes, &low = block.deposit->lower_axes,
             &high = block.deposit->upper_axes;
  const DepositObservation& seen = *block.deposit;
  return {Axes::sorted(LogSize(axes.L, low.L, high.L).at(scores[0]),
                       LogSize(axes.I, low.I, high.I).at(scores[1]),
                       LogSize(axes.S, low.S, high.S).at(scores[2])),
          LogSize(seen.volume, seen.lower_volume, seen.upper_volume).at(scores[3])};
}

}  // namespace

BlockSizes median_block_sizes(const MeasuredBlock& block) { return sizes_at(block, {}); }

BlockSizes draw_block_sizes(const MeasuredBlock& block, Random& random) {
  const double common = std::sqrt(kAxisErrorCorrelation);
  const double own = std::sqrt(1.0 - kAxisErrorCorrelation);
  // Standard deviation of the sum of three scores.
  const double sum_deviation = std::sqrt(3.0 + 6.0 * kAxisErrorCorrelation);
  const double shared = common * random.normal();
  const double l = shared + own * random.normal();
  const double i = shared + own * random.normal();
  const double s = shared + own * random.normal();
  return sizes_at(block, {l, i, s, (l + i + s) / sum_deviation});
}

}  // namespace clast
