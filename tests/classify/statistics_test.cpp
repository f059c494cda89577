#include "classify/statistics.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/random.hpp"

namespace clast {
namespace {

TEST(Quantile, InterpolatesBetweenOrderStatistics) {
  const std::vector<double> sample = {4, 1, 3, 2, 5};
  EXPECT_EQ(quantile(sample, 0.0), 1.0);
  EXPECT_EQ(quantile(sample, 0.5), 3.0);
  EXPECT_EQ(quantile(sample, 1.0), 5.0);
  EXPECT_NEAR(quantile(sample, 0.1), 1.4, 1e-15);
  EXPECT_EQ(quantile({7.0}, 0.3), 7.0);
}

TEST(WeightedQuantile, OfEqualWeightsHasItsStepsAtTheirMiddles) {
  const std::vector<double> sample = {3, 1, 2, 4}, equal(4, 2.5);
  EXPECT_NEAR(weighted_quantile(sample, equal, 0.5), 2.5, 1e-15);
  EXPECT_NEAR(weighted_quantile(sample, equal, 0.125), 1.0, 1e-15);
  EXPECT_EQ(weighted_quantile(sample, equal, 0.0), 1.0);
  EXPECT_EQ(weighted_quantile(sample, equal, 1.0), 4.0);
}

// A block of 98 % of the mass is the median by mass.
TEST(WeightedQuantile, GoesWhereTheWeightIs) {
  EXPECT_NEAR(weighted_quantile(std::vector<double>{1, 2, 3}, std::vector<double>{1, 1, 98}, 0.51),
              3.0, 1e-12);
}

TEST(RankCorrelation, IsOneForAnyRisingCurve) {
  std::vector<double> x, rising, falling, flat;
  for (int i = 0; i < 20; ++i) {
    x.push_back(i);
    rising.push_back(std::exp(0.3 * i));
    falling.push_back(-std::pow(i, 3));
    flat.push_back(2.0);
  }
  EXPECT_NEAR(rank_correlation(x, rising), 1.0, 1e-15);
  EXPECT_NEAR(rank_correlation(x, falling), -1.0, 1e-15);
  EXPECT_EQ(rank_correlation(x, flat), 0.0);
}

// Ranks 1, 2.5, 2.5, 4 against 1, 2, 3, 4: covariance 4.5, variances 4.5 and 5.
TEST(RankCorrelation, SharesRanksAmongTies) {
  EXPECT_NEAR(rank_correlation(std::vector<double>{1, 2, 2, 3}, std::vector<double>{1, 2, 3, 4}),
              4.5 / std::sqrt(4.5 * 5.0), 1e-15);
}

TEST(KolmogorovSmirnov, StatisticIsTheLargestGap) {
  EXPECT_NEAR(kolmogorov_smirnov({1, 2, 3, 4}, {3, 4, 5, 6}).statistic, 0.5, 1e-15);
  EXPECT_EQ(kolmogorov_smirnov({1, 2, 3}, {4, 5}).statistic, 1.0);
  EXPECT_EQ(kolmogorov_smirnov({1, 2, 2, 3}, {3, 2, 1, 2}).statistic, 0.0);
  EXPECT_EQ(kolmogorov_smirnov({1, 2, 2, 3}, {3, 2, 1, 2}).p_value, 1.0);
}

// Table of the limit distribution: 1.2238 is exceeded in 10 %, 1.3581 in 5 %, 1.6276 in 1 %.
TEST(KolmogorovSmirnov, ProbabilitiesAreThoseOfTheTable) {
  constexpr int kCount = 20000;
  std::vector<double> a;
  for (int i = 0; i < kCount; ++i) a.push_back(i);
  for (const auto& [lambda, p] : {std::pair{1.2238, 0.10}, {1.3581, 0.05}, {1.6276, 0.01}}) {
    // Shifted by D of its range a uniform sample is D away.
    const double root = std::sqrt(0.5 * kCount);
    const double D = lambda / (root + 0.12 + 0.11 / root);
    std::vector<double> b;
    for (const double value : a) b.push_back(value + std::round(D * kCount) - 0.5);
    const TestResult result = kolmogorov_smirnov(a, b);
    EXPECT_NEAR(result.statistic, D, 1.0 / kCount);
    EXPECT_NEAR(result.p_value, p, 0.02 * p);
  }
}

// Where there is no difference one pair in twenty is below 5 %.
TEST(KolmogorovSmirnov, CallsEqualPopulationsDifferentOnceInTwenty) {
  Random random(3);
  int rejected = 0;
  for (int i = 0; i < 1000; ++i) {
    std::vector<double> a, b;
    for (int j = 0; j < 60; ++j) a.push_back(random.normal());
    for (int j = 0; j < 40; ++j) b.push_back(random.normal());
    rejected += kolmogorov_smirnov(a, b).p_value < 0.05;
  }
  EXPECT_NEAR(rejected, 50, 25);  // 3.6 standard errors
}

// 2 x 2: N (ad - bc)^2 / (row and column sums); one degree: p = erfc(sqrt(x / 2)).
TEST(ChiSquared, OfTwoClassesInClosedForm) {
  const TestResult result =
      chi_squared(std::vector<std::size_t>{30, 20}, std::vector<std::size_t>{15, 35});
  const double x = 100.0 * std::pow(30.0 * 35.0 - 20.0 * 15.0, 2) / (50.0 * 50.0 * 45.0 * 55.0);
  EXPECT_NEAR(result.statistic, x, 1e-12);
  EXPECT_EQ(result.degrees, 1u);
  EXPECT_NEAR(result.p_value, std::erfc(std::sqrt(0.5 * x)), 1e-14);
  EXPECT_FALSE(result.small_counts);
}

// Even degrees: 2: exp(-x/2); 4: exp(-x/2)(1 + x/2). Small and large x take the two ways to the
// sum.
TEST(ChiSquared, ProbabilitiesOfEvenDegreesInClosedForm) {
  for (const std::size_t step : {2u, 8u, 40u}) {
    const std::vector<std::size_t> a = {100 + step, 100, 100 - step},
                                   b = {100 - step, 100, 100 + step};
    const TestResult three = chi_squared(a, b);
    EXPECT_EQ(three.degrees, 2u);
    EXPECT_NEAR(three.p_value, std::exp(-0.5 * three.statistic), 1e-14);
    const std::vector<std::size_t> c = {100 + step, 100, 100 - step, 90, 0, 50},
                                   d = {100 - step, 100, 100 + step, 90, 0, 50};
    const TestResult five = chi_squared(c, d);
    EXPECT_EQ(five.degrees, 4u) << "a class that is empty in both is no class";
    const double half = 0.5 * five.statistic;
    EXPECT_NEAR(five.p_value, std::exp(-half) * (1.0 + half), 1e-14);
  }
}

TEST(ChiSquared, SaysWhenCountsAreSmallAndWhenThereIsNothingToCompare) {
  EXPECT_TRUE(
      chi_squared(std::vector<std::size_t>{3, 20}, std::vector<std::size_t>{4, 30}).small_counts);
  const TestResult one =
      chi_squared(std::vector<std::size_t>{5, 0}, std::vector<std::size_t>{9, 0});
  EXPECT_EQ(one.degrees, 0u);
  EXPECT_EQ(one.p_value, 1.0);
}

}  // namespace
}  // namespace clast
