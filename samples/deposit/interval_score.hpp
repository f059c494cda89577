#pragma once
/// Scores of estimates with bounds and intervals against true values.
#include <cstddef>
#include <limits>
#include <optional>
#include <span>

namespace clast {

/// Level of the two-sided intervals that are scored.
inline constexpr double kIntervalLevel = 0.9;

/// Estimate of a positive quantity. NaN where nothing is stated; infinite bounds are allowed.
struct Estimate {
  static constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
  double value = kUnknown;
  double low = kUnknown, high = kUnknown;      ///< hard bounds
  double low90 = kUnknown, high90 = kUnknown;  ///< two-sided 90 % interval
};
struct JudgedEstimate {
  double truth = 0.0;
  Estimate estimate;
};

/// Scores of ranges. Widths and scores are relative to the true values.
struct RangeScore {
  std::size_t count = 0;      ///< number of stated ranges
  double coverage = 0.0;      ///< fraction that contains the truth
  double median_width = 0.0;  ///< infinite if half of them are unbounded
  /// Mean of the interval score at the level 0.9: width plus 20 times the distance of a truth
  /// outside (Gneiting and Raftery 2007, eq. 43); smaller is better.
  double mean_score = 0.0;
};

/// Interval from `low_factor` to `high_factor` times each estimate.
struct ConstantFactorInterval {
  double low_factor = 1.0, high_factor = 1.0;
  RangeScore score;
};

/// Scores of estimates of one quantity.
struct EstimateScore {
  std::size_t count = 0;               ///< number of stated values
  double median_absolute_error = 0.0;  ///< relative to the truth
  double bias = 0.0;                   ///< median of the signed relative error
  RangeScore bounds;
  RangeScore intervals;
  /// Interval of constant factors that covers as many of the truths as the stated intervals and has
  /// the smallest mean score; empty if no interval covers its truth. It knows the truths, so that
  /// intervals which adapt to each block are better only if they say more.
  std::optional<ConstantFactorInterval> constant_factor;
};

/// Returns the interval score at a level, for positive widths.
/// @cite gneiting2007
double interval_score(double low, double high, double truth, double level);

/// Scores estimates. All members of the result are zero or empty without estimates.
EstimateScore score_estimates(std::span<const JudgedEstimate> estimates);

}  // namespace clast
