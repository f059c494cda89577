#include "library/deposit_observations.hpp"

#include <gtest/gtest.h>

#include "tests/library/block_samples.hpp"

namespace clast {
namespace {

/// A block of a deposit: a cuboid of 3 x 2 x 1 m at a place.
Block deposit_block(const std::string& id, const Vec3& place) {
  Block block = filled_block(id);
  for (Vec3& vertex : block.surface.vertices) vertex += place;
  block.volume_bracket->intervals = {5.6, 6.8, {{2.9, 1.9, 0.9}, {3.1, 2.1, 1.1}}};
  block.deposit =
      DepositRecord{.points = 1200, .spacing = 0.05, .visible_fraction = 0.55, .confidence = 0.9};
  return block;
}

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

}  // namespace
}  // namespace clast
