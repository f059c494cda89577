#pragma once
/// The difference of two groups: how large it is, how sure, and what that means.
#include <cmath>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "core/statistics/statistics.hpp"

namespace clast {

/// The verdict on a difference.
enum class Verdict {
  kSignificant,          ///< it is more than chance gives
  kDistributionDiffers,  ///< it can be chance, but the values are distributed in another way
  kInsignificantAfterCorrection,  ///< its interval excludes zero, but one of so many does that by
                                  ///< chance
  kInsignificant,                 ///< it can be chance
  kGroundDependent,               ///< its sign depends on the draw of the ground
  kUntested,  ///< nothing shows what is chance: one realisation only, or values that do not scatter
  kTooFewValues,  ///< too few values to judge by
};

/// One group less another.
struct Contrast {
  double estimate = 0.0;
  double standard_error = NAN;       ///< not a number where the interval is from a bootstrap
  double degrees_of_freedom = NAN;   ///< degrees of freedom of the standard error
  std::optional<Interval> interval;  ///< 95 %; none without a test
  std::optional<double> p_value;     ///< uncorrected, two-sided
  std::optional<double> p_holm;      ///< corrected for all that were tested with it
  std::size_t tests = 0;             ///< that it was corrected for

  /// The corrected test is below 5 %.
  bool is_significant() const { return p_holm && *p_holm < 0.05; }
  bool excludes_zero() const { return interval && (interval->low > 0.0 || interval->high < 0.0); }
  /// By the corrected test and the interval.
  Verdict verdict() const;
};

/// Interval and p-value of Student's t.
/// @param standard_error  positive
/// @cite student1908
Contrast student_contrast(double estimate, double standard_error, double degrees_of_freedom);

/// P-values after Holm's correction for having looked so many times: in ascending order the i-th is
/// multiplied by the number of those not yet passed, and none is below one before it. Below 0.05
/// means that the chance of any false finding among all is below 0.05.
/// @param p_values  in any order; the result is in the same
/// @cite holm1979
std::vector<double> holm_adjusted(std::span<const double> p_values);

/// The same of the contrasts of a family, each with a p-value.
void apply_holm_correction(const std::vector<Contrast*>& family);

/// The same of the contrasts in a list; those without a p-value are no tests.
/// @param contrast_of  of an item, a function or a member
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
