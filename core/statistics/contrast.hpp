#pragma once
/// Difference of two groups with its uncertainty, and the verdict of its test.
#include <cmath>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "core/statistics/statistics.hpp"

namespace clast {

enum class ContrastVerdict {
  kSignificant,          ///< significant after correction
  kDistributionDiffers,  ///< the means do not differ significantly, but the distributions do
  kInsignificantAfterCorrection,  ///< interval excludes zero, corrected test not significant
  kInsignificant,                 ///< not significant
  kGroundDependent,               ///< the sign of the difference depends on the ground draw
  kUntested,  ///< no test is possible: a single realisation, or values without scatter
  kTooFewValues,
};

/// Difference between two groups, with its uncertainty and test.
struct Contrast {
  double estimate = 0.0;
  double standard_error = NAN;         ///< NaN if the interval comes from a bootstrap
  double degrees_of_freedom = NAN;     ///< degrees of freedom of the standard error
  std::optional<Interval> interval;    ///< 95 % interval; empty if there is no test
  std::optional<double> p_value;       ///< two-sided, uncorrected
  std::optional<double> holm_p_value;  ///< p-value corrected for multiple tests by Holm's method
  std::size_t family_size = 0;         ///< number of tests for which `holm_p_value` is corrected

  /// True if the corrected p-value is below 0.05.
  bool is_significant() const { return holm_p_value && *holm_p_value < 0.05; }
  bool excludes_zero() const { return interval && (interval->low > 0.0 || interval->high < 0.0); }
  /// Returns the verdict that follows from the corrected test and the interval.
  ContrastVerdict verdict() const;
};

/// Makes a contrast with interval and p-value by Student's t.
/// @param standard_error  positive
/// @cite student1908
Contrast student_contrast(double estimate, double standard_error, double degrees_of_freedom);

/// Adjusts p-values by Holm's method for multiple tests. The i-th smallest of n values is
/// multiplied by n - i + 1, and the results are made monotone. Rejecting below 0.05 limits the
/// family-wise error rate to 0.05.
/// @param p_values  p-values in any order; the result has the same order
/// @cite holm1979
std::vector<double> holm_adjusted(std::span<const double> p_values);

/// Applies Holm's correction to a family of contrasts. Each must have a p-value.
void apply_holm_correction(const std::vector<Contrast*>& family);

/// Applies Holm's correction to the contrasts of a list. Contrasts without a p-value are ignored.
/// @param contrast_of  returns the contrast of an item
template <class Item, class Of = std::identity>
void correct_multiple_tests(std::vector<Item>& items, const Of& contrast_of = {}) {
  std::vector<Contrast*> tested;
  for (Item& item : items) {
    Contrast& contrast = std::invoke(contrast_of, item);
    if (contrast.p_value) tested.push_back(&contrast);
  }
  apply_holm_correction(tested);
}

}  // namespace clast
