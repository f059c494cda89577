// Outcomes against the shape of blocks.
#include "study/compare/shape_trends.hpp"

#include <gtest/gtest.h>

#include "core/random.hpp"
#include "tests/study/hand_made_results.hpp"
#include "tests/support/refusal.hpp"

namespace clast {
namespace {

/// Twelve blocks of one mass from five points, three runs each: the runout grows by `slope` m from
/// I/L = 0.4 to 0.95.
CampaignResults series_results(double slope, std::uint64_t seed) {
  Random random(seed);
  CampaignResults results = hand_made_results();
  const BlockSummary like = results.blocks[0];
  results.blocks.clear();
  results.runs.clear();
  results.crossings.clear();
  results.release_points.assign(5, results.release_points[0]);
  std::uint32_t run = 0;
  for (std::uint32_t block = 0; block < 12; ++block) {
    results.blocks.push_back(like);
    BlockSummary& added = results.blocks.back();
    added.id = "F" + std::to_string(block);
    const double ratio = 0.4 + 0.05 * block;
    added.axes = {1.0, ratio, 0.4};
    const double of_block = slope * (ratio - 0.4) / 0.55 + 0.5 * random.normal();
    for (std::uint32_t point = 0; point < 5; ++point) {
      for (int i = 0; i < 3; ++i, ++run) {
        results.runs.push_back(
            hand_made_run(run, block, 20.0 + 3.0 * point + of_block + random.normal(), 0.0));
        results.runs.back().point = point;
      }
    }
  }
  results.planned_runs = run;
  return results;
}

std::vector<ShapeTrend> trends_of(CampaignResults results, double margin) {
  std::vector<CampaignResults> files;
  files.push_back(std::move(results));
  ComparisonOptions options;
  options.margin = margin;
  return compute_shape_trends(compare(std::move(files), options)).at(0).trends;
}

TEST(ShapeTrends, FindWhatRunoutGrowsWith) {
  const std::vector<ShapeTrend> trends = trends_of(series_results(6.0, 3), 2.0);
  ASSERT_FALSE(trends.empty());
  const ShapeTrend& first = trends.front();
  EXPECT_EQ(first.outcome, "runout");
  EXPECT_EQ(first.property, "I/L");
  EXPECT_EQ(first.blocks, 12u);
  EXPECT_EQ(first.runs, 180u);
  EXPECT_GT(first.trend.statistic, 0.8);
  EXPECT_LT(first.corrected_p, 0.01);
  EXPECT_NEAR(first.limit, 0.7, 1e-9);
  EXPECT_NEAR(first.halves.estimate, 6.0 * 0.3 / 0.55, 1.0) << "means 0.525 and 0.825";
  EXPECT_GT(*first.equivalence, 0.5);
  for (const ShapeTrend& trend : trends) {
    EXPECT_NE(trend.property, "S/L") << "all have the same";
    EXPECT_NE(trend.property, "mass");
    EXPECT_EQ(trend.equivalence.has_value(), trend.unit == "m");
  }
}

TEST(ShapeTrends, SayThatNothingMattersWhereNothingDoes) {
  const ShapeTrend first = trends_of(series_results(0.0, 4), 2.0).front();
  EXPECT_GT(first.corrected_p, 0.05);
  EXPECT_LT(*first.equivalence, 0.05);
  EXPECT_LT(first.detectable_difference, 2.0);
  EXPECT_LT(*first.runs_needed, 180.0);
}

TEST(ShapeTrends, NeedFourBlocksThatDoNotStay) {
  CampaignResults few = series_results(6.0, 3);
  std::erase_if(few.runs, [](const RunRecord& run) { return run.block > 2; });
  EXPECT_TRUE(trends_of(std::move(few), 2.0).empty());
  EXPECT_TRUE(contains(refusal([] { trends_of(series_results(6.0, 3), -1.0); }), "margin -1 m"));
}

}  // namespace
}  // namespace clast
