#pragma once
/// Numbers that a campaign knows only as a distribution.
#include "core/random.hpp"

namespace clast {

/// A number, or the law that it is drawn from.
struct Distribution {
  enum class Law { kFixed, kUniform, kNormal, kLogNormal };
  Law law = Law::kFixed;
  double first = 0.0;   ///< the number; lower bound; mean; median
  double second = 0.0;  ///< upper bound; standard deviation; standard deviation of the logarithm
  /// Normal and log-normal draws that are not above `low` and at most `high` are drawn again.
  double low = -1e300;
  double high = 1e300;

  bool fixed() const { return law == Law::kFixed; }
  /// The number, middle, mean or median.
  double central() const;
  /// Of the draws.
  double mean() const;
  double draw(Random& random) const;
  /// The value that the share `below` of all draws lies below; the number itself where it is fixed.
  /// @param below  in [0, 1)
  double quantile(double below) const;
};

}  // namespace clast
