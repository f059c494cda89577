#pragma once
/// Probability distributions of campaign parameters.
#include "core/random.hpp"

namespace clast {

/// Fixed number or probability distribution.
struct Distribution {
  enum class Law { kFixed, kUniform, kNormal, kLogNormal };
  Law law = Law::kFixed;
  double first = 0.0;   ///< fixed value, lower bound, mean or median, depending on the law
  double second = 0.0;  ///< upper bound or standard deviation (of the logarithm for kLogNormal)
  /// Lower limit of draws: normal and log-normal draws outside (low, high] are repeated.
  double low = -1e300;
  double high = 1e300;

  bool is_fixed() const { return law == Law::kFixed; }
  /// Returns the central value: fixed value, midpoint, mean or median, depending on the law.
  double central_value() const;
  /// Returns the mean of the truncated distribution.
  double mean() const;
  double draw(Random& random) const;
  /// Returns the quantile for a probability. A fixed value is returned unchanged.
  /// @param below  probability in [0, 1)
  double quantile(double below) const;
};

}  // namespace clast
