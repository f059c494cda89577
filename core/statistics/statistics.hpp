#pragma once
/// Small statistics on samples.
#include <cstddef>
#include <span>
#include <vector>

namespace clast {

/// Of a sample; all zero when it is empty.
struct Summary {
  std::size_t count = 0;
  double mean = 0.0;
  double std = 0.0;  ///< sample standard deviation (n - 1); 0 for one value
  double median = 0.0;
  double p95 = 0.0;  ///< linear between order statistics (Hyndman & Fan type 7)
  double max = 0.0;
};

/// @param values  finite; sums run in their order, so equal input gives equal bits
Summary summarise(std::span<const double> values);

/// The value below which the share `p` of the sample lies, linear between order statistics.
/// @param sorted  ascending, not empty
/// @param p       in [0, 1]
/// @cite hyndman1996
double quantile(std::span<const double> sorted, double p);

/// The arithmetic mean, summed in the order of the values; not empty.
double arithmetic_mean(std::span<const double> values);

/// The median; the larger of the two middle values where their number is even. Not empty.
double upper_median(std::vector<double> values);

/// Bounds of a value; of a probability that nothing is known of, unless they are set.
struct Interval {
  double low = 0.0;
  double high = 1.0;
};

/// Decimals that are known of a value with that interval, `max_decimals` at most: the interval is
/// five steps of the last one wide, or more.
int known_decimals(const Interval& interval, int max_decimals);

/// Wilson's 95 % interval for a probability seen `hits` times in `trials` independent trials; [0,
/// 1] when there was none.
/// @cite wilson1927
Interval wilson_interval(std::size_t hits, std::size_t trials);

/// The same for an observed share that is worth so many independent trials, not a whole number
/// where trials weigh unequally.
/// @param share   in [0, 1]
/// @param trials  positive
Interval wilson_interval_of_proportion(double proportion, double trials);

}  // namespace clast
