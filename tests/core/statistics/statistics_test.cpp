#include "core/statistics/statistics.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/random.hpp"

namespace clast {
namespace {

TEST(Summary, OfFourNumbersIsAsComputedByHand) {
  const SampleSummary summary = summarise_sample(std::vector<double>{4.0, 1.0, 3.0, 2.0});
  EXPECT_EQ(summary.count, 4u);
  EXPECT_DOUBLE_EQ(summary.mean, 2.5);
  EXPECT_DOUBLE_EQ(summary.std, std::sqrt(5.0 / 3.0));  // (2.25 + 0.25 + 0.25 + 2.25) / 3
  EXPECT_DOUBLE_EQ(summary.median, 2.5);
  EXPECT_DOUBLE_EQ(summary.p95, 3.85);  // place 0.95 * 3 = 2.85 between 3 and 4
  EXPECT_DOUBLE_EQ(summary.max, 4.0);
}

TEST(Summary, OfNothingIsZero) {
  const SampleSummary summary = summarise_sample({});
  EXPECT_EQ(summary.count, 0u);
  EXPECT_EQ(summary.mean, 0.0);
  EXPECT_EQ(summary.max, 0.0);
}

TEST(Summary, OfOneValueHasNoSpread) {
  const SampleSummary summary = summarise_sample(std::vector<double>{-7.0});
  EXPECT_EQ(summary.mean, -7.0);
  EXPECT_EQ(summary.std, 0.0);
  EXPECT_EQ(summary.median, -7.0);
  EXPECT_EQ(summary.p95, -7.0);
  EXPECT_EQ(summary.max, -7.0);
}

TEST(Summary, SpreadKeepsItsDigitsAtMapCoordinates) {
  const SampleSummary summary =
      summarise_sample(std::vector<double>{5e6 + 1, 5e6 + 2, 5e6 + 3, 5e6 + 4});
  EXPECT_NEAR(summary.std, std::sqrt(5.0 / 3.0), 1e-9);
}

class RandomSample : public testing::TestWithParam<unsigned> {};

TEST_P(RandomSample, ShiftsAndScalesWithItsValues) {
  Random random(GetParam());
  std::vector<double> values, changed;
  const std::size_t count = 2 + random.uniform_index(200);
  for (std::size_t i = 0; i < count; ++i) {
    values.push_back(random.normal());
    changed.push_back(3.0 * values.back() + 5.0);
  }
  const SampleSummary before = summarise_sample(values), after = summarise_sample(changed);
  EXPECT_NEAR(after.mean, 3.0 * before.mean + 5.0, 1e-12);
  EXPECT_NEAR(after.std, 3.0 * before.std, 1e-12);
  EXPECT_NEAR(after.median, 3.0 * before.median + 5.0, 1e-12);
  EXPECT_NEAR(after.p95, 3.0 * before.p95 + 5.0, 1e-12);
  EXPECT_NEAR(after.max, 3.0 * before.max + 5.0, 1e-12);
}

TEST_P(RandomSample, QuantileAtAnOrderStatisticIsThatValueAndNeverFalls) {
  Random random(GetParam());
  std::vector<double> values(2 + random.uniform_index(50));
  for (double& value : values) value = random.uniform(-10.0, 10.0);
  std::sort(values.begin(), values.end());
  const double last = static_cast<double>(values.size() - 1);
  for (std::size_t k = 0; k < values.size(); ++k) {
    EXPECT_NEAR(quantile(values, static_cast<double>(k) / last), values[k], 1e-9);
  }
  for (int k = 1; k <= 100; ++k) {
    EXPECT_LE(quantile(values, (k - 1) / 100.0), quantile(values, k / 100.0));
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomSample, testing::Range(0u, 20u));

TEST(Decimals, AreThoseThatTheIntervalLeaves) {
  EXPECT_EQ(significant_decimals({10.0, 17.0}, 4), 0);
  EXPECT_EQ(significant_decimals({0.208, 0.983}, 4), 1);
  EXPECT_EQ(significant_decimals({0.135, 0.2}, 4), 2);
  EXPECT_EQ(significant_decimals({5.0, 5.0}, 4), 4) << "no wider than nothing";
  EXPECT_EQ(significant_decimals({-INFINITY, INFINITY}, 4), 0);
}

TEST(WilsonInterval, EndsSolveTheScoreEquation) {
  for (const std::size_t trials : {1u, 7u, 64u, 256u}) {
    for (std::size_t hits = 0; hits <= trials; ++hits) {
      const double n = static_cast<double>(trials), seen = static_cast<double>(hits) / n;
      const Interval interval = wilson_interval(hits, trials);
      for (const double p : {interval.low, interval.high}) {
        EXPECT_NEAR((seen - p) * (seen - p),
                    1.959963984540054 * 1.959963984540054 * p * (1 - p) / n, 1e-14);
      }
      EXPECT_LE(interval.low, seen);
      EXPECT_GE(interval.high, seen);
    }
  }
}

TEST(WilsonInterval, OfNoHitEndsAtTheKnownBound) {
  const double z2 = 1.959963984540054 * 1.959963984540054;
  EXPECT_EQ(wilson_interval(0, 10).low, 0.0);
  EXPECT_NEAR(wilson_interval(0, 10).high, z2 / (10.0 + z2), 1e-15);
  EXPECT_EQ(wilson_interval(10, 10).high, 1.0);
}

TEST(WilsonInterval, WithoutTrialsIsEverything) {
  EXPECT_EQ(wilson_interval(0, 0).low, 0.0);
  EXPECT_EQ(wilson_interval(0, 0).high, 1.0);
}

}  // namespace
}  // namespace clast
