#pragma once
/// Probability distributions of campaign parameters.
#include "core/random.hpp"

namespace clast {

/// Fixed number or probability distribution.
struct Distribution {
  enum class Law { kFixed, kUniform, kNormal, kLogNormal };
  Law law = Law::kFixed;
  double first = 0.0;   ///< fixed value; lower bound; mean; median
  double second = 0.0;  ///< upper bound; standard deviation; standard deviation of the logarithm
  /// Truncation: normal and log-normal draws outside (low, high] are redrawn.
  double low = -1e300;
  double high = 1e300;

  bool fixed() const { return law == Law::kFixed; }
  /// Returns the fixed value, midpoint, mean or median.
  double central_value() const;
  /// Returns the mean of the truncated distribution.
  double mean() const;
  double draw(Random& random) const;
  /// Returns the quantile of a probability; the number itself if it is fixed.
  /// @param below  probability in [0, 1)
  double quantile(double below) const;
};

}  // namespace clast
