// Closed forms and printed tables, none of them by the series and fractions under test.
#include "core/statistics/probability.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/types.hpp"

namespace clast {
namespace {

// Even degrees of freedom: the chance of fewer than freedom/2 events of a Poisson process with mean
// x/2. Odd ones: the normal tail and the same sum over half-integers.
double chi_squared_by_sum(double x, int freedom) {
  const double y = x / 2.0;
  double sum = 0.0;
  if (freedom % 2 == 0) {
    double term = std::exp(-y);
    for (int k = 0; k < freedom / 2; ++k) {
      sum += term;
      term *= y / (k + 1);
    }
    return sum;
  }
  sum = std::erfc(std::sqrt(y));
  double term = std::exp(-y) * std::sqrt(y) / std::tgamma(1.5);
  for (int k = 0; k < freedom / 2; ++k) {
    sum += term;
    term *= y / (k + 1.5);
  }
  return sum;
}

TEST(Probability, NormalQuantilesAreTheInverse) {
  EXPECT_NEAR(normal_quantile(0.975), 1.959963984540054, 1e-12);
  EXPECT_EQ(normal_quantile(0.5), 0.0);
  for (const double p : {1e-12, 0.01, 0.3, 0.9999}) {
    EXPECT_NEAR(normal_cdf(normal_quantile(p)) / p, 1.0, 1e-9);
  }
}

TEST(ChiSquaredAbove, EqualsItsFiniteSums) {
  for (int freedom = 1; freedom <= 40; ++freedom) {
    for (const double x : {1e-6, 0.01, 0.5, 1.0, 3.0, 9.9, 20.0, 41.0, 80.0, 200.0}) {
      const double expected = chi_squared_by_sum(x, freedom);
      EXPECT_NEAR(chi_squared_upper_tail(x, freedom), expected, 1e-12 + 1e-11 * expected)
          << x << ", " << freedom;
    }
  }
  EXPECT_EQ(chi_squared_upper_tail(0.0, 3), 1.0);
}

// Upper 5 % and 1 % points as every table prints them.
TEST(ChiSquaredAbove, HitsThePrintedPoints) {
  struct Point {
    double x;
    int freedom;
    double p;
  };
  for (const auto& [x, freedom, p] : {Point{3.841459, 1, 0.05},
                                      {5.991465, 2, 0.05},
                                      {7.814728, 3, 0.05},
                                      {16.918978, 9, 0.05},
                                      {6.634897, 1, 0.01},
                                      {11.344867, 3, 0.01},
                                      {21.665994, 9, 0.01},
                                      {36.415029, 24, 0.05}}) {
    EXPECT_NEAR(chi_squared_upper_tail(x, freedom), p, 1e-7) << x;
  }
}

// Freedom 1 is Cauchy's distribution, 2 and 4 are algebraic.
TEST(StudentBeyond, EqualsItsClosedForms) {
  for (const double t : {1e-9, 0.1, 0.7, 1.0, 2.0, 5.0, 40.0, 1e4}) {
    // Boost takes an arcsine close to 1 here: 8e-12 off at t = 1e-9.
    EXPECT_NEAR(student_two_sided_tail(t, 1), 1.0 - 2.0 / kPi * std::atan(t),
                t < 1e-6 ? 1e-11 : 1e-13);
    EXPECT_NEAR(student_two_sided_tail(t, 2), 1.0 - t / std::sqrt(2.0 + t * t), 1e-13);
    const double s = t / std::sqrt(4.0 + t * t);
    EXPECT_NEAR(student_two_sided_tail(t, 4), 1.0 - s * (1.0 + 0.5 * (1.0 - s * s)), 1e-13);
    EXPECT_EQ(student_two_sided_tail(-t, 7), student_two_sided_tail(t, 7));
  }
  EXPECT_EQ(student_two_sided_tail(0.0, 5), 1.0);
  EXPECT_EQ(student_two_sided_tail(INFINITY, 5), 0.0);
}

TEST(StudentBeyond, HitsThePrintedPointsAndTendsToTheNormal) {
  EXPECT_NEAR(student_two_sided_tail(2.228139, 10), 0.05, 1e-7);
  EXPECT_NEAR(student_two_sided_tail(3.169273, 10), 0.01, 1e-7);
  EXPECT_NEAR(student_two_sided_tail(2.042272, 30), 0.05, 1e-7);
  EXPECT_NEAR(student_two_sided_tail(1.959964, 1e9), 0.05, 1e-7);
}

TEST(NormalBelow, HitsThePrintedPoints) {
  EXPECT_NEAR(normal_cdf(1.959963984540054), 0.975, 1e-15);
  EXPECT_NEAR(normal_cdf(-1.6448536269514722), 0.05, 1e-15);
  EXPECT_EQ(normal_cdf(0.0), 0.5);
}

// Each of the two series, summed far, where the other is used.
TEST(KolmogorovAbove, BothSeriesAgreeAndHitThePrintedPoints) {
  for (double x = 0.3; x < 3.0; x += 0.05) {
    double alternating = 0.0, theta = 0.0;
    for (int k = 1; k <= 400; ++k) {
      alternating += (k % 2 ? 2.0 : -2.0) * std::exp(-2.0 * k * k * x * x);
      theta += std::exp(-(2.0 * k - 1) * (2.0 * k - 1) * kPi * kPi / (8.0 * x * x));
    }
    EXPECT_NEAR(kolmogorov_upper_tail(x), alternating, 1e-12) << x;
    EXPECT_NEAR(kolmogorov_upper_tail(x), 1.0 - std::sqrt(2.0 * kPi) / x * theta, 1e-12) << x;
  }
  EXPECT_NEAR(kolmogorov_upper_tail(1.3580986), 0.05, 1e-7);
  EXPECT_NEAR(kolmogorov_upper_tail(1.6276236), 0.01, 1e-7);
  EXPECT_NEAR(kolmogorov_upper_tail(1.2238479), 0.10, 1e-7);
  EXPECT_EQ(kolmogorov_upper_tail(0.0), 1.0);
  EXPECT_NEAR(kolmogorov_upper_tail(0.05), 1.0, 1e-15);
}

}  // namespace
}  // namespace clast
