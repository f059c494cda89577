#include "core/statistics/contrast.hpp"

#include <algorithm>
#include <numeric>

#include "core/statistics/probability.hpp"

namespace clast {

ContrastVerdict Contrast::verdict() const {
  if (!holm_p_value) return ContrastVerdict::kUntested;
  if (is_significant())
    return excludes_zero() ? ContrastVerdict::kSignificant : ContrastVerdict::kDistributionDiffers;
  return excludes_zero() ? ContrastVerdict::kInsignificantAfterCorrection
                         : ContrastVerdict::kInsignificant;
}

Contrast student_contrast(double estimate, double standard_error, double degrees_of_freedom) {
  constexpr double kUpper = 0.975;  // a two-sided interval of 95 % ends there
  const double half = student_quantile(kUpper, degrees_of_freedom) * standard_error;
  Contrast found;
  found.estimate = estimate;
  found.standard_error = standard_error;
  found.degrees_of_freedom = degrees_of_freedom;
  found.interval = Interval{estimate - half, estimate + half};
  found.p_value = student_two_sided_tail(estimate / standard_error, degrees_of_freedom);
  return found;
}

std::vector<double> holm_adjusted(std::span<const double> p_values) {
  std::vector<std::size_t> order(p_values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t i, std::size_t j) { return p_values[i] < p_values[j]; });
  std::vector<double> corrected(p_values.size());
  double largest = 0.0;
  for (std::size_t i = 0; i < order.size(); ++i) {
    const double left = static_cast<double>(order.size() - i);
    largest = std::max(largest, std::min(1.0, left * p_values[order[i]]));
    corrected[order[i]] = largest;
  }
  return corrected;
}

void apply_holm_correction(const std::vector<Contrast*>& family) {
  std::vector<double> p_values;
  for (const Contrast* one : family) p_values.push_back(*one->p_value);
  const std::vector<double> corrected = holm_adjusted(p_values);
  for (std::size_t i = 0; i < family.size(); ++i) {
    family[i]->holm_p_value = corrected[i];
    family[i]->family_size = family.size();
  }
}

}  // namespace clast
