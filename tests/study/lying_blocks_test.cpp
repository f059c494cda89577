// Where blocks of a deposit lie and how they are turned, against boxes placed by hand.
#include "study/lying_blocks.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/angle.hpp"
#include "core/random.hpp"
#include "tests/study/boxes_that_stay.hpp"

namespace clast {
namespace {

Quat turned(double degrees, const Vec3& axis) {
  return Quat(Eigen::AngleAxisd(degrees * kRadiansPerDegree, axis));
}

TEST(LyingBlocks, HaveTheTrendAndPlungeOfTheirLongSide) {
  CampaignResults results = boxes_that_stay();
  // Downslope is +x, so that -y is to the right.
  results.runs[0].result.final_state.orientation = turned(-30.0, Vec3::UnitZ());
  results.runs[1].result.final_state.orientation = turned(180.0 + 40.0, Vec3::UnitZ());
  results.runs[2].result.final_state.orientation = turned(20.0, Vec3::UnitY());
  results.runs[3].result.final_state.orientation = turned(-20.0, Vec3::UnitY());
  results.runs[4].result.final_state.orientation = turned(90.0, Vec3::UnitZ());
  const std::vector<LyingBlock> blocks = lying_blocks(compared(std::move(results)));
  ASSERT_EQ(blocks.size(), 6u);
  EXPECT_NEAR(blocks[0].trend, 30.0 * kRadiansPerDegree, 1e-9);
  EXPECT_NEAR(blocks[0].plunge, 0.0, 1e-9);
  EXPECT_NEAR(blocks[1].trend, -40.0 * kRadiansPerDegree, 1e-9);
  // Whichever end is down, the plunge is positive.
  EXPECT_NEAR(blocks[2].plunge, 20.0 * kRadiansPerDegree, 1e-9);
  EXPECT_NEAR(blocks[3].plunge, 20.0 * kRadiansPerDegree, 1e-9);
  EXPECT_NEAR(blocks[2].trend, 0.0, 1e-9);
  EXPECT_NEAR(std::abs(blocks[4].trend), 90.0 * kRadiansPerDegree, 1e-9);
}

TEST(LyingBlocks, HaveTheirPlaceInTheDeposit) {
  CampaignResults results = boxes_that_stay();
  results.runs[1].result.final_state.position.y() = -3.0;
  results.stays[5].removed_at = 3.0;
  const std::vector<LyingBlock> blocks = lying_blocks(compared(std::move(results)));
  ASSERT_EQ(blocks.size(), 5u);
  EXPECT_EQ(blocks[4].realisation, 1u);
  // Starts are at x = -10, the deposit of the first realisation has its centre at x = 4.
  EXPECT_NEAR(blocks[0].along, 10.0, 1e-6);
  EXPECT_NEAR(blocks[0].ahead, -4.0, 1e-6);
  EXPECT_NEAR(blocks[2].ahead, 4.0, 1e-6);
  EXPECT_NEAR(blocks[1].aside, 3.0, 1e-6);
  EXPECT_NEAR(blocks[0].aside, 0.0, 1e-6);
}

TEST(LyingBlocks, AreHalfWayUpAloneAndByLayersInAPile) {
  CampaignResults results = boxes_that_stay();
  results.runs[4].result.final_state.position = {0.5, 0.25, 0.75};  // upon run 3
  const std::vector<LyingBlock> blocks = lying_blocks(compared(std::move(results)));
  EXPECT_NEAR(blocks[0].height, 0.25, 1e-9);
  EXPECT_NEAR(blocks[0].relative_height, 0.5, 1e-9);
  EXPECT_NEAR(blocks[3].relative_height, 0.25, 1e-9);
  EXPECT_NEAR(blocks[4].relative_height, 0.75, 1e-9);
  EXPECT_NEAR(blocks[4].height, 0.75, 1e-9);
}

TEST(LyingBlocks, AreNoneWhereNoBlockStayed) {
  EXPECT_TRUE(lying_blocks(compared(hand_made_results())).empty());
}

TEST(TopOver, IsTheUpperFace) {
  const TriangleMesh skin = box_mesh({2.0, 1.0, 3.0});
  EXPECT_DOUBLE_EQ(*top_over(skin, {0.3, 0.7}), 3.0);
  EXPECT_FALSE(top_over(skin, {2.1, 0.5}));
  EXPECT_FALSE(top_over(skin, {1.0, -0.1}));
}

TEST(NearestOthers, AreThoseOfTheDistancesOfAll) {
  Random random(3);
  for (const std::size_t count : {2u, 3u, 60u}) {
    std::vector<Vec3> places(count);
    for (Vec3& place : places) {
      // Places in steps, so that distances repeat.
      place = {std::floor(random.uniform(0.0, 9.0)), std::floor(random.uniform(0.0, 9.0)), 0.0};
    }
    const std::vector<std::size_t> nearest = nearest_others(places);
    for (std::size_t i = 0; i < count; ++i) {
      std::size_t expected = i == 0 ? 1 : 0;
      for (std::size_t k = 0; k < count; ++k) {
        if (k != i && (places[k] - places[i]).norm() < (places[expected] - places[i]).norm()) {
          expected = k;
        }
      }
      EXPECT_EQ(nearest[i], expected) << i << " of " << count;
    }
  }
}

}  // namespace
}  // namespace clast
