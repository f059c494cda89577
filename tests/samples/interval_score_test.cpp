#include "samples/deposit/interval_score.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace clast {
namespace {

TEST(IntervalScore, IsTheWidthInsideAndGrowsTwentyfoldWithTheDistanceOutside) {
  EXPECT_DOUBLE_EQ(interval_score(1.0, 3.0, 2.0, 0.9), 2.0);
  EXPECT_DOUBLE_EQ(interval_score(1.0, 3.0, 1.0, 0.9), 2.0);
  EXPECT_NEAR(interval_score(1.0, 3.0, 3.5, 0.9), 2.0 + 20.0 * 0.5, 1e-12);
  EXPECT_NEAR(interval_score(1.0, 3.0, 0.9, 0.9), 2.0 + 20.0 * 0.1, 1e-12);
  EXPECT_NEAR(interval_score(1.0, 3.0, 4.0, 0.5), 2.0 + 4.0 * 1.0, 1e-12);
}

TEST(EstimateScore, ErrorsAreRelativeToTheTruth) {
  const std::vector<JudgedEstimate> estimates = {
      {2.0, {.value = 2.2}}, {4.0, {.value = 3.8}}, {1.0, {.value = 1.02}}, {5.0, {}}};
  const EstimateScore score = score_estimates(estimates);
  EXPECT_EQ(score.count, 3u);
  EXPECT_NEAR(score.median_absolute_error, 0.05, 1e-12);  // of 0.10, 0.05, 0.02
  EXPECT_NEAR(score.bias, 0.02, 1e-12);                   // of 0.10, -0.05, 0.02
  EXPECT_EQ(score.bounds.count, 0u);
  EXPECT_FALSE(score.constant_factor);
}

TEST(EstimateScore, CoverageAndWidthOfBoundsAndIntervals) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const std::vector<JudgedEstimate> estimates = {
      {1.0, {.value = 1.0, .low = 0.5, .high = 2.0, .low90 = 0.9, .high90 = 1.1}},
      {2.0, {.value = 2.0, .low = 1.0, .high = kInfinity, .low90 = 1.0, .high90 = 1.5}},
      {4.0, {.value = 4.0, .low = 4.1, .high = 8.0, .low90 = 4.0, .high90 = 6.0}}};
  const EstimateScore score = score_estimates(estimates);
  EXPECT_EQ(score.bounds.count, 3u);
  EXPECT_DOUBLE_EQ(score.bounds.coverage, 2.0 / 3.0);
  EXPECT_DOUBLE_EQ(score.bounds.median_width, 1.5);  // of 1.5, infinite, 0.975
  EXPECT_DOUBLE_EQ(score.intervals.coverage, 2.0 / 3.0);
  EXPECT_DOUBLE_EQ(score.intervals.median_width, 0.25);  // of 0.2, 0.25, 0.5
  EXPECT_NEAR(score.intervals.mean_score, (0.2 + (0.25 + 20.0 * 0.5 / 2.0) + 0.5) / 3.0, 1e-12);
}

// Ratios of truth to estimate 0.8, 1.0, 1.1 and 1.5. The stated intervals cover three truths; of
// three neighbouring ratios, 0.8 to 1.1 is the narrower range, 0.3 wide.
TEST(EstimateScore, TheBestConstantFactorsCoverAsMany) {
  std::vector<JudgedEstimate> estimates;
  for (const double ratio : {1.5, 0.8, 1.1, 1.0}) {
    estimates.push_back({ratio, {.value = 1.0, .low90 = 0.5, .high90 = 1.2}});
  }
  const EstimateScore score = score_estimates(estimates);
  EXPECT_EQ(score.intervals.coverage, 0.75);
  ASSERT_TRUE(score.constant_factor);
  EXPECT_EQ(score.constant_factor->low_factor, 0.8);
  EXPECT_EQ(score.constant_factor->high_factor, 1.1);
  EXPECT_EQ(score.constant_factor->score.coverage, 0.75);
  const double widths = 0.3 / 0.8 + 0.3 / 1.0 + 0.3 / 1.1 + 0.3 / 1.5;
  EXPECT_NEAR(score.constant_factor->score.mean_score, (widths + 20.0 * 0.4 / 1.5) / 4.0, 1e-12);
}

TEST(EstimateScore, IsEmptyWithoutEstimates) {
  const EstimateScore score = score_estimates({});
  EXPECT_EQ(score.count, 0u);
  EXPECT_EQ(score.median_absolute_error, 0.0);
  EXPECT_EQ(score.intervals.count, 0u);
}

}  // namespace
}  // namespace clast
