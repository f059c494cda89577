// Intervals of means and of their differences, against closed forms of Student's t and by how often
// they hold what is true.
#include "core/statistics/mean_intervals.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "core/random.hpp"

namespace clast {
namespace {

SampleSummary of(const std::vector<double>& values) { return summarise_sample(values); }

/// With two degrees of freedom P(|T| > t) = 1 - t/sqrt(2 + t^2), so 95 % lie within this.
const double kWithTwo = 0.95 * std::sqrt(2.0 / (1.0 - 0.95 * 0.95));

TEST(MeanInterval, IsThatOfStudentsT) {
  const std::optional<Interval> interval = mean_interval(of({1.0, 4.0, 7.0}));
  ASSERT_TRUE(interval);
  const double half_width = kWithTwo * 3.0 / std::sqrt(3.0);
  EXPECT_NEAR(interval->low, 4.0 - half_width, 1e-9);
  EXPECT_NEAR(interval->high, 4.0 + half_width, 1e-9);
}

TEST(MeanInterval, EndsWhereNoMeanCanLie) {
  const std::optional<Interval> interval = mean_interval(of({0.9, 1.0, 0.95}), {0.0, 1.0});
  ASSERT_TRUE(interval);
  EXPECT_EQ(interval->high, 1.0);
  EXPECT_NEAR(interval->low, 0.95 - kWithTwo * 0.05 / std::sqrt(3.0), 1e-9);
}

TEST(MeanInterval, NeedsTwoValuesAndSpread) {
  EXPECT_FALSE(mean_interval(of({})));
  EXPECT_FALSE(mean_interval(of({3.0})));
  EXPECT_FALSE(mean_interval(of({3.0, 3.0, 3.0})));
  EXPECT_FALSE(mean_interval(of({0.4, 0.4, 0.4})));  // whose sum over three is not 0.4
}

TEST(WelchDifference, OfGroupsOfEqualSizeAndSpreadIsThatOfPooledOnes) {
  // Variances are 2, their means have 1 each, and there are 2 + 2 - 2 degrees of freedom.
  const Contrast found = welch_difference(of({0.0, 2.0}), of({10.0, 12.0}));
  ASSERT_TRUE(found.interval);
  const double error = std::sqrt(2.0), t = 10.0 / error;
  EXPECT_DOUBLE_EQ(found.estimate, -10.0);
  EXPECT_NEAR(found.standard_error, error, 1e-12);
  EXPECT_NEAR(found.degrees_of_freedom, 2.0, 1e-12);
  EXPECT_NEAR(found.interval->low, -10.0 - kWithTwo * error, 1e-8);
  EXPECT_NEAR(found.interval->high, -10.0 + kWithTwo * error, 1e-8);
  EXPECT_NEAR(*found.p_value, 1.0 - t / std::sqrt(2.0 + t * t), 1e-12);
}

TEST(WelchDifference, HasTheDegreesOfFreedomOfTheGroupThatScatters) {
  const Contrast found = welch_difference(of({5.0, 5.0, 5.0, 5.0, 5.0}), of({1.0, 4.0, 7.0}));
  ASSERT_TRUE(found.interval);
  EXPECT_NEAR(found.degrees_of_freedom, 2.0, 1e-12);
  EXPECT_NEAR(found.interval->high - found.interval->low, 2.0 * kWithTwo * std::sqrt(3.0), 1e-8);
}

TEST(WelchDifference, NeedsTwoValuesOfEachAndSpread) {
  EXPECT_FALSE(welch_difference(of({1.0}), of({1.0, 2.0, 3.0})).interval);
  EXPECT_FALSE(welch_difference(of({1.0, 2.0}), of({})).interval);
  EXPECT_FALSE(welch_difference(of({1.0, 1.0}), of({2.0, 2.0})).p_value);
}

/// Four realisations of one group and nine of another that scatters three times as much.
TEST(WelchDifference, HoldsTheTrueDifferenceInNineteenOfTwentyStudies) {
  Random random(71);
  constexpr int kStudies = 5000;
  int held = 0, found = 0;
  for (int study = 0; study < kStudies; ++study) {
    std::vector<double> first(4), second(9);
    for (double& value : first) value = 30.0 + random.normal();
    for (double& value : second) value = 28.0 + 3.0 * random.normal();
    const Contrast one = welch_difference(of(first), of(second));
    ASSERT_TRUE(one.interval);
    held += one.interval->low <= 2.0 && 2.0 <= one.interval->high;
    // The test and the interval say the same.
    const bool excludes_zero = one.excludes_zero();
    EXPECT_EQ(excludes_zero, *one.p_value < 0.05);
    found += excludes_zero;
  }
  // Three standard deviations of the count are 0.9 %.
  EXPECT_NEAR(static_cast<double>(held) / kStudies, 0.95, 0.012);
  EXPECT_GT(found, kStudies / 20);
}

}  // namespace
}  // namespace clast
