#pragma once
/// Difference of two groups with its uncertainty and verdict.
#include <cmath>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "core/statistics/statistics.hpp"

namespace clast {

enum class Verdict {
  kSignificant,          ///< significant after correction
  kDistributionDiffers,  ///< the mean difference is not significant, but the distributions differ
  kInsignificantAfterCorrection,  ///< the interval excludes zero, but the corrected test is not
                                  ///< significant
  kInsignificant,                 ///< not significant
  kGroundDependent,               ///< the sign depends on the ground draw
  kUntested,  ///< chance cannot be estimated: a single realisation, or values without scatter
  kTooFewValues,
};

/// Difference of one group minus another.
struct Contrast {
  double estimate = 0.0;
  double standard_error = NAN;       ///< NaN if the interval is from a bootstrap
  double degrees_of_freedom = NAN;   ///< of the standard error
  std::optional<Interval> interval;  ///< 95 %; empty without a test
  std::optional<double> p_value;     ///< two-sided, uncorrected
  std::optional<double> p_holm;      ///< corrected for all tests of the family
  std::size_t tests = 0;             ///< number of tests of the family

  /// True if the corrected p-value is below 0.05.
  bool is_significant() const { return p_holm && *p_holm < 0.05; }
  bool excludes_zero() const { return interval && (interval->low > 0.0 || interval->high < 0.0); }
  /// Returns the verdict of the corrected test and the interval.
  Verdict verdict() const;
};

/// Makes a contrast with the interval and p-value of Student's t.
/// @param standard_error  positive
/// @cite student1908
Contrast student_contrast(double estimate, double standard_error, double degrees_of_freedom);

/// Adjusts p-values by Holm's method for multiple tests: the i-th smallest is multiplied by the
/// number of remaining tests, and values are made monotone. Rejecting below 0.05 limits the
/// family-wise error rate to 0.05.
/// @param p_values  in any order, which the result keeps
/// @cite holm1979
std::vector<double> holm_adjusted(std::span<const double> p_values);

/// Applies Holm's correction to a family of contrasts, each with a p-value.
void apply_holm_correction(const std::vector<Contrast*>& family);

/// Applies Holm's correction to the contrasts of a list; those without a p-value are ignored.
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
