#include "core/statistics/probability.hpp"

#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/non_central_t.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <cassert>
#include <cmath>

#include "core/types.hpp"

namespace clast {

double normal_cdf(double z) { return 0.5 * std::erfc(-z / std::sqrt(2.0)); }

double normal_quantile(double p) {
  assert(p > 0.0 && p < 1.0);
  return quantile(boost::math::normal(), p);
}

double chi_squared_upper_tail(double x, double degrees_of_freedom) {
  assert(degrees_of_freedom > 0.0 && x >= 0.0);
  return cdf(complement(boost::math::chi_squared(degrees_of_freedom), x));
}

double student_two_sided_tail(double t, double degrees_of_freedom) {
  assert(degrees_of_freedom > 0.0);
  return 2.0 * cdf(complement(boost::math::students_t(degrees_of_freedom), std::abs(t)));
}

double student_quantile(double p, double degrees_of_freedom) {
  assert(p > 0.0 && p < 1.0 && degrees_of_freedom > 0.0);
  return quantile(boost::math::students_t(degrees_of_freedom), p);
}

double noncentral_student_upper_tail(double t, double degrees_of_freedom, double noncentrality) {
  assert(degrees_of_freedom > 0.0);
  return cdf(complement(boost::math::non_central_t(degrees_of_freedom, noncentrality), t));
}

double kolmogorov_upper_tail(double x) {
  if (x <= 0.0) return 1.0;
  if (x < 1.0) {
    // The same sum after Jacobi's transformation, which converges where the other does not.
    double sum = 0.0;
    for (int k = 1; k <= 9; k += 2) sum += std::exp(-k * k * kPi * kPi / (8.0 * x * x));
    return 1.0 - std::sqrt(2.0 * kPi) / x * sum;
  }
  double sum = 0.0;
  for (int k = 1; k <= 7; ++k) sum += (k % 2 == 1 ? 2.0 : -2.0) * std::exp(-2.0 * k * k * x * x);
  return std::clamp(sum, 0.0, 1.0);
}

}  // namespace clast
