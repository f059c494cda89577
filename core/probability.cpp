#include "core/probability.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "core/types.hpp"

namespace clast {
namespace {

constexpr double kEnough = std::numeric_limits<double>::epsilon();
constexpr double kTiny = 1e-300;     // in place of a denominator that vanishes
constexpr int kMostTerms = 100'000;  // the fractions need about the root of their argument

/// lim of b0 + a1/(b1 + a2/(b2 + ...)) after Lentz, terms from `next(k)`, k = 1, 2, ...
template <class Next>
double continued_fraction(double b0, Next next) {
  double value = b0 == 0.0 ? kTiny : b0;
  double c = value, d = 0.0;
  for (int k = 1; k < kMostTerms; ++k) {
    const auto [a, b] = next(k);
    d = b + a * d;
    if (d == 0.0) d = kTiny;
    c = b + a / c;
    if (c == 0.0) c = kTiny;
    d = 1.0 / d;
    const double change = c * d;
    value *= change;
    if (std::abs(change - 1.0) <= kEnough) break;
  }
  return value;
}

struct Term {
  double a, b;
};

/// x^a e^-x / Gamma(a)
double gamma_density_factor(double a, double x) {
  return std::exp(a * std::log(x) - x - std::lgamma(a));
}

/// I_x(a, b), with y = 1 - x given for its digits.
double beta_fraction(double a, double b, double x, double y) {
  const double front = std::exp(std::lgamma(a + b) - std::lgamma(a) - std::lgamma(b) +
                                a * std::log(x) + b * std::log(y)) /
                       a;
  return front / continued_fraction(1.0, [&](int k) {
           const int m = k / 2;
           const double numerator =
               k % 2 == 0 ? m * (b - m) * x / ((a + 2 * m - 1) * (a + 2 * m))
                          : -(a + m) * (a + b + m) * x / ((a + 2 * m) * (a + 2 * m + 1));
           return Term{numerator, 1.0};
         });
}

}  // namespace

double normal_below(double z) { return 0.5 * std::erfc(-z / std::sqrt(2.0)); }

double chi_squared_above(double x, double freedom) {
  assert(freedom > 0.0 && x >= 0.0);
  if (x == 0.0) return 1.0;
  const double a = freedom / 2.0;
  const double y = x / 2.0;
  if (y < a + 1.0) {
    double term = 1.0 / a, sum = term;
    for (int k = 1; k < kMostTerms && term > kEnough * sum; ++k) {
      term *= y / (a + k);
      sum += term;
    }
    return std::max(0.0, 1.0 - sum * gamma_density_factor(a, y));
  }
  return gamma_density_factor(a, y) / continued_fraction(y + 1.0 - a, [&](int k) {
           return Term{-k * (k - a), y + 2.0 * k + 1.0 - a};
         });
}

double student_beyond(double t, double freedom) {
  assert(freedom > 0.0);
  if (t == 0.0) return 1.0;
  if (!std::isfinite(t)) return 0.0;
  const double a = freedom / 2.0, b = 0.5;
  const double x = freedom / (freedom + t * t);
  const double y = t * t / (freedom + t * t);
  // The fraction converges on the side of the mean where x is small.
  if (x < (a + 1.0) / (a + b + 2.0)) return beta_fraction(a, b, x, y);
  return std::clamp(1.0 - beta_fraction(b, a, y, x), 0.0, 1.0);
}

double kolmogorov_above(double x) {
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
