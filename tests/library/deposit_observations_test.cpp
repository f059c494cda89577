#include "library/deposit_observations.hpp"

#include <gtest/gtest.h>

#include "tests/library/deposit_blocks.hpp"

namespace clast {
namespace {

TEST(DepositObservations, AreThoseOfTheRecord) {
  const std::vector<Block> blocks = {deposit_block("A", Vec3::Zero())};
  const auto observations = make_deposit_observations(blocks);
  ASSERT_TRUE(observations[0]);
  const DepositObservation& seen = *observations[0];
  EXPECT_EQ(seen.points, 1200u);
  EXPECT_EQ(seen.spacing, 0.05);
  EXPECT_EQ(seen.visible_fraction, 0.55);
  EXPECT_EQ(seen.confidence, 0.9);
  EXPECT_EQ(seen.volume, blocks[0].mass.volume);
  EXPECT_EQ(seen.lower_axes.I, 1.9);
  EXPECT_EQ(seen.upper_axes.S, 1.1);
  EXPECT_EQ(seen.upper_volume, 6.8);
  EXPECT_NEAR(seen.plan_area, 6.0, 0.2);
  EXPECT_EQ(seen.exposed_area, seen.plan_area);
}

TEST(DepositObservations, OtherBlocksHideOnlyThoseOfTheirScan) {
  std::vector<Block> blocks = {deposit_block("A", Vec3::Zero()),
                               deposit_block("B", {1.5, 0.0, 2.0})};
  auto observations = make_deposit_observations(blocks);
  EXPECT_NEAR(observations[0]->exposed_area, 0.5 * observations[0]->plan_area, 0.2);
  EXPECT_EQ(observations[1]->exposed_area, observations[1]->plan_area);
  blocks[1].source.sha256 = std::string(64, 'b');
  observations = make_deposit_observations(blocks);
  EXPECT_EQ(observations[0]->exposed_area, observations[0]->plan_area);
}

TEST(DepositObservations, OtherBlocksHaveNone) {
  std::vector<Block> blocks = {filled_block("single"), deposit_block("A", Vec3::Zero())};
  blocks[1].volume_bracket->intervals.reset();
  for (const auto& seen : make_deposit_observations(blocks)) EXPECT_FALSE(seen);
}

TEST(WeightedDeposit, SmallBlocksStandForMoreThanLargeOnes) {
  std::vector<Block> blocks = deposit_of_sizes();
  const auto deposit = weigh_deposit(pointers_to(blocks));
  ASSERT_TRUE(deposit);
  EXPECT_GT(deposit->weights.front(), deposit->weights.back());
  blocks[3].deposit->confidence = 0.45;
  EXPECT_NEAR(weigh_deposit(pointers_to(blocks))->weights[3], 0.5 * deposit->weights[3], 1e-9);
}

TEST(WeightedDeposit, NeedsDepositsOnly) {
  std::vector<Block> blocks = deposit_of_sizes();
  blocks.push_back(filled_block("single"));
  EXPECT_FALSE(weigh_deposit(pointers_to(blocks)));
  blocks.resize(2);
  EXPECT_FALSE(weigh_deposit(pointers_to(blocks)));
}

TEST(WeightedDeposit, ChoosesInProportionToTheWeights) {
  Random random(1);
  const std::vector<double> weights = {1.0, 0.0, 3.0};
  std::vector<int> counts(3, 0);
  for (int k = 0; k < 8000; ++k) ++counts[choose_by_weight(weights, random)];
  EXPECT_EQ(counts[1], 0);
  EXPECT_NEAR(counts[0], 2000, 5 * 39);  // five standard deviations
}

}  // namespace
}  // namespace clast
