#pragma once
/// Summary statistics of samples.
#include <cstddef>
#include <span>
#include <vector>

namespace clast {

/// Summary statistics of a sample. All members are zero if it is empty.
struct SampleSummary {
  std::size_t count = 0;
  double mean = 0.0;
  double std = 0.0;  ///< sample standard deviation (n - 1); 0 for one value
  double median = 0.0;
  double p95 = 0.0;  ///< 95th percentile, linear between order statistics (Hyndman & Fan type 7)
  double max = 0.0;
};

/// Computes the summary statistics of a sample.
/// @param values  finite values; summed in their order, so that equal input gives equal bits
SampleSummary summarise_sample(std::span<const double> values);

/// Returns a quantile, linear between order statistics.
/// @param sorted  ascending, not empty
/// @param p  in [0, 1]
/// @cite hyndman1996
double quantile(std::span<const double> sorted, double p);

/// Returns the arithmetic mean of at least one value, summed in the order of the values.
double arithmetic_mean(std::span<const double> values);

/// Returns the median of at least one value; for even sizes, the larger of the two middle values.
double upper_median(std::vector<double> values);

/// Closed interval. The default is [0, 1], the interval of an unknown probability.
struct Interval {
  double low = 0.0;
  double high = 1.0;
};

/// Returns the number of significant decimals of a value with a given interval. It is the smallest
/// for which the interval is at least five units of the last decimal wide.
int significant_decimals(const Interval& interval, int max_decimals);

/// Returns Wilson's 95 % interval of a probability, after `hits` successes in `trials` independent
/// trials; [0, 1] if there are no trials.
/// @cite wilson1927
Interval wilson_interval(std::size_t hits, std::size_t trials);

/// Wilson's interval of an observed proportion, for an effective, possibly fractional sample size.
/// @param trials  positive
Interval wilson_interval_of_proportion(double proportion, double trials);

}  // namespace clast
