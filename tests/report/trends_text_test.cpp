// What rises and falls with the shape of the blocks, in words.
#include "report/text/trends_text.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/refusal.hpp"

namespace clast {
namespace {

ShapeTrend trend(const std::string& property, double correlation, double p) {
  ShapeTrend found;
  found.outcome = "runout";
  found.unit = "m";
  found.property = property;
  found.blocks = 66;
  found.runs = 1584;
  found.trend = {correlation, p, false};
  found.corrected_p = p;
  found.halves.estimate = 5.2;
  found.halves.interval = Interval{3.1, 7.3};
  found.detectable_difference = 3.0;
  return found;
}

TEST(TrendsText, SaysWhatRisesAndFallsAndWhatCouldBeFound) {
  const std::vector<ShapeTrends> trends = {
      {0, {trend("S/L", 0.714, 1e-4), trend("mass", -0.3, 0.02), trend("rounding", 0.1, 0.6)}}};
  const std::vector<std::string> text = describe_trends(trends, std::nullopt);
  ASSERT_EQ(text.size(), 4u);
  EXPECT_EQ(text[0],
            "Runout rises with S/L (rank correlation 0.71, p < 0.001), falls with mass (rank "
            "correlation -0.30, p = 0.02); no significant trend with rounding.");
  EXPECT_EQ(text[1],
            "If the blocks are divided into two halves by S/L, the runout differs by 5.2 m (3.1 to "
            "7.3); a "
            "campaign of this size detects a difference of 3 m in 80 % of cases.");
}

TEST(TrendsText, SaysWhetherADifferenceIsWithinTheMargin) {
  ShapeTrend none = trend("S/L", 0.1, 0.5);
  none.halves.estimate = 0.2;
  none.halves.interval = Interval{-0.5, 0.9};
  none.equivalence = 0.004;
  none.runs_needed = 3564.0;
  const std::string within = describe_trends({{0, {none}}}, 2.0).back();
  EXPECT_TRUE(contains(within, "within +-2 m: the effect is negligible (p = 0.004)")) << within;
  EXPECT_TRUE(contains(within, "and 2 m with 3600 runs")) << within;
  none.equivalence = 0.3;
  EXPECT_TRUE(contains(describe_trends({{0, {none}}}, 2.0).back(), "not shown to be within +-2 m"));
  none.halves.interval = Interval{2.5, 4.0};
  EXPECT_TRUE(contains(describe_trends({{0, {none}}}, 2.0).back(), ", more than +-2 m;"));
  EXPECT_EQ(describe_trends({{0, {none}}}, 2.0).front(),
            "Runout has no significant trend with S/L.");
}

// 1,600 runs of 16 blocks have D = 1 + 99 x 0.1, and 4 D s^2 7.849/x^2 = 1,600 gives x.
TEST(TrendsText, SaysBeforeACampaignWhatItCouldTellApart) {
  PlannedPower plan{1600, 16, 30, 5.0, 1.0};
  EXPECT_NEAR(plan.design_effect(), 10.9, 1e-12);
  EXPECT_NEAR(plan.detectable_difference(), 5.0 * std::sqrt(4.0 * 10.9 * 7.8489 / 1600.0), 1e-3);
  const std::string text = describe_planned_power(plan);
  EXPECT_TRUE(contains(text, "a difference in runout of 2.3 m between two halves")) << text;
  EXPECT_TRUE(contains(text, "the standard deviation of runout is 5 m as in 30 trial runs"))
      << text;
  EXPECT_TRUE(contains(text, "; 1 m takes 8600 runs")) << text;
}

TEST(TrendsText, SaysWhyNothingCanBeSaidOfAMargin) {
  const PlannedPower known{1600, 16, 30, 5.0, 1.0};
  const auto said = [&](auto change) {
    PlannedPower plan = known;
    change(plan);
    return describe_planned_power(plan);
  };
  EXPECT_TRUE(
      contains(said([](PlannedPower& plan) { plan.blocks = 2; }),
               "the dry run can't say whether this campaign detects a difference of 1 m "
               "with 2 blocks: it compares two halves of the blocks, which requires 4 or more"));
  EXPECT_TRUE(contains(said([](PlannedPower& plan) { plan.trial_runs = 0; }), "no trial run came"));
  EXPECT_TRUE(
      contains(said([](PlannedPower& plan) { plan.trial_runs = 1; }), "only one trial run"));
  EXPECT_TRUE(
      contains(said([](PlannedPower& plan) { plan.runout_deviation = 0.0; }), "are all equal"));
  EXPECT_TRUE(contains(said([](PlannedPower& plan) {
                         plan = {};
                         plan.margin = 2.0;
                       }),
                       "blocks are persistent"));
  EXPECT_EQ(said([](PlannedPower& plan) {
              plan.blocks = 2;
              plan.margin.reset();
            }),
            "")
      << "nothing was asked";
}

}  // namespace
}  // namespace clast
