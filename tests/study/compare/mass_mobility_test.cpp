// Blocks that go together against the same alone, with runouts written by hand.
#include "study/compare/mass_mobility.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "report/text/contrast_text.hpp"
#include "tests/study/boxes_that_stay.hpp"

namespace clast {
namespace {

TEST(ExpectedLargest, IsThatOfAllDraws) {
  const std::vector<double> values = {6.0, 0.0, 3.0};
  EXPECT_NEAR(expected_maximum(values, 1.0), 3.0, 1e-12);
  // Of nine pairs one has 0, three 3 and five 6 as the larger.
  EXPECT_NEAR(expected_maximum(values, 2.0), (3.0 * 3.0 + 5.0 * 6.0) / 9.0, 1e-12);
  EXPECT_NEAR(expected_maximum(values, 1000.0), 6.0, 1e-9);
}

/// Two realisations of three boxes, all boxes of one as far; the third box is of another class.
CampaignResults together(double first, double second) {
  CampaignResults results = boxes_that_stay();
  for (std::size_t run = 0; run < 6; ++run) {
    results.runs[run].block = run % 3 == 2 ? 1 : 0;
    results.runs[run].result.final_state.position.x() = -10.0 + (run < 3 ? first : second);
  }
  return results;
}

/// Runs of the same boxes, three from each of two points.
CampaignResults alone(const std::vector<double>& runouts) {
  CampaignResults results = boxes_that_stay();
  results.persistent_blocks.reset();
  results.persistent_block_records.clear();
  results.release_points.push_back(results.release_points.front());
  for (std::size_t run = 0; run < 6; ++run) {
    results.runs[run].block = run % 3 == 2 ? 1 : 0;
    results.runs[run].point = static_cast<std::uint32_t>(run / 3);
    results.runs[run].result.final_state.position.x() = -10.0 + runouts[run];
  }
  return results;
}

TEST(MassMobility, IsTheDifferenceOfRealisationsAndReleasePoints) {
  const std::vector<DepositMobility> all = compute_mass_mobility(
      compared(together(10.0, 12.0), alone({19.0, 20.0, 21.0, 21.0, 22.0, 23.0})));
  ASSERT_EQ(all.size(), 3u);
  const DepositMobility& every = all[0];
  EXPECT_EQ(every.file, 0u);
  EXPECT_EQ(every.single_block_file, 1u);
  EXPECT_EQ(every.blocks, 6u);
  EXPECT_EQ(every.runs, 6u);
  EXPECT_EQ(every.alone_runout.count, 2u) << "release points";
  EXPECT_NEAR(every.together_runout.mean, 11.0, 1e-6);
  EXPECT_NEAR(every.alone_runout.mean, 21.0, 1e-6);
  ASSERT_TRUE(every.difference.interval);
  // Means of 10 and 12 against 20 and 22: the standard error is sqrt(2), with two degrees of
  // freedom.
  const double half_width = 0.95 * std::sqrt(2.0 / (1.0 - 0.95 * 0.95)) * std::sqrt(2.0);
  EXPECT_NEAR(every.difference.interval->low, -10.0 - half_width, 1e-5);
  EXPECT_NEAR(every.together_toe.mean, 11.0, 1e-6);
  EXPECT_NEAR(every.alone_toe,
              expected_maximum(std::vector<double>{19.0, 20.0, 21.0, 21.0, 22.0, 23.0}, 3.0), 1e-6);
  EXPECT_EQ(describe_effect(every), "all: 11.0 m together, 21.0 m alone; 10 m less (4 to 16 m)");
  EXPECT_NEAR(every.start_distance, 0.0, 1e-6);
  EXPECT_NEAR(every.mass_ratio, 1.0, 1e-12);
  EXPECT_EQ(all[1].group, "class compact");
  EXPECT_EQ(all[2].group, "class elongated");
  EXPECT_EQ(all[2].blocks, 2u);
  EXPECT_NEAR(all[2].alone_runout.mean, 22.0, 1e-6);
}

TEST(MassMobility, SaysWhereStartsAndMassesDiffer) {
  CampaignResults single = alone({19.0, 20.0, 21.0, 21.0, 22.0, 23.0});
  for (RunRecord& run : single.runs) {
    run.start.position.y() += 30.0;
    run.result.final_state.position.y() += 30.0;
  }
  for (BlockSummary& block : single.blocks) block.mass *= 2.0;
  const std::vector<DepositMobility> all =
      compute_mass_mobility(compared(together(10.0, 12.0), single));
  ASSERT_FALSE(all.empty());
  EXPECT_NEAR(all[0].start_distance, 30.0, 1e-6);
  EXPECT_TRUE(describe_effect(all[0]).ends_with(
      "; their release points are 30 m apart; the mean mass together is 0.5 times that alone"))
      << describe_effect(all[0]);
}

TEST(MassMobility, OfOneReleasePointIsOverRuns) {
  CampaignResults single = alone({19.0, 20.0, 21.0, 21.0, 22.0, 23.0});
  for (RunRecord& run : single.runs) run.point = 0;
  const std::vector<DepositMobility> all =
      compute_mass_mobility(compared(together(10.0, 12.0), single));
  ASSERT_FALSE(all.empty());
  EXPECT_EQ(all[0].alone_runout.count, 6u);
}

TEST(MassMobility, IsNoneForOtherBlocksAndWithoutSingleRuns) {
  CampaignResults others = alone({19.0, 20.0, 21.0, 21.0, 22.0, 23.0});
  for (BlockSummary& block : others.blocks) block.id += " of another library";
  EXPECT_TRUE(compute_mass_mobility(compared(together(10.0, 12.0), others)).empty());
  EXPECT_TRUE(compute_mass_mobility(compared(together(10.0, 12.0), together(10.0, 12.0))).empty());
  EXPECT_TRUE(compute_mass_mobility(compared(hand_made_results())).empty());
}

}  // namespace
}  // namespace clast
