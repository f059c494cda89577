// What blocks that stay leave behind, against boxes that lie on level ground.
#include "study/compare/realisation_deposits.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/study/boxes_that_stay.hpp"

namespace clast {
namespace {

TEST(DepositResults, OfBoxesThatLieOnThePlane) {
  CampaignResults results = boxes_that_stay();
  // In the second realisation one lies on another, and one is removed.
  results.runs[4].result.final_state.position = {0.0, 0.0, 0.75};
  results.persistent_block_records[5].removed_at = 3.0;
  // Both masses start as three boxes one over the other, the highest with its top at 10.25 m.
  results.persistent_blocks->at_once = true;
  const Comparison comparison = compared(std::move(results));
  const DepositResults deposits = measure_deposits(comparison);
  ASSERT_EQ(deposits.realisations.size(), 2u);
  const DepositMeasures &first = deposits.realisations[0], &second = deposits.realisations[1];
  EXPECT_EQ(first.blocks, 3u);
  EXPECT_EQ(first.deposited_blocks, 3u);
  EXPECT_EQ(second.deposited_blocks, 2u);
  EXPECT_NEAR(first.volume, 3.0, 1e-12);
  EXPECT_NEAR(second.mass, 4000.0, 1e-9);
  EXPECT_NEAR(first.thickness, 0.5, 1e-9);
  EXPECT_NEAR(second.thickness, 1.0, 1e-9);
  // Cells of 0.1 m fit the boxes.
  EXPECT_NEAR(deposits.rasters.cell_size, 0.1, 1e-12);
  EXPECT_NEAR(first.area, 6.0, 1e-9);
  EXPECT_NEAR(first.bulk_volume, 3.0, 1e-9);
  EXPECT_NEAR(second.area, 2.0, 1e-9);
  EXPECT_NEAR(second.bulk_volume, 2.0, 1e-9);
  EXPECT_NEAR(second.start_volume, 3.0, 1e-12);
  EXPECT_NEAR(second.start_bulk_volume, 2.0 * 10.25, 1e-9);
  // Places are on the map.
  EXPECT_LT((first.centre - kMapOrigin - Vec3(4.0, 0.0, 0.25)).norm(), 1e-6);
  EXPECT_LT((first.start_centre - kMapOrigin - Vec3(-10.0, 0.0, 9.0)).norm(), 1e-6);
  EXPECT_LT((first.crest - kMapOrigin - Vec3(-10.0, 0.0, 10.0)).norm(), 1e-6);
  EXPECT_LT((first.toe - kMapOrigin - Vec3(8.0, 0.0, 0.25)).norm(), 1e-6);
  EXPECT_NEAR(height_length_ratio(first.crest, first.toe), 9.75 / 18.0, 1e-9);
  // The mean over both: half of the realisations have a box at the far end.
  const auto layer = [&](std::size_t i, const Vec2& place) {
    const Vec2 map = place + kMapOrigin.head<2>();
    return deposits.rasters.layers[i]
        .values[deposits.rasters.index({static_cast<std::int64_t>(std::floor(map.y() / 0.1)),
                                        static_cast<std::int64_t>(std::floor(map.x() / 0.1))})];
  };
  EXPECT_EQ(deposits.rasters.layers[0].name, "Deposit_mean");
  EXPECT_NEAR(layer(0, {8.05, 0.05}), 0.25, 1e-6);
  EXPECT_NEAR(layer(0, {0.05, 0.05}), 0.75, 1e-6);
  EXPECT_NEAR(layer(1, {0.05, 0.05}), 1.0, 1e-6);
  EXPECT_NEAR(layer(2, {8.05, 0.05}), 0.5, 1e-6);
  EXPECT_TRUE(std::isnan(layer(0, {2.05, 0.05})));
}

TEST(DepositResults, WithoutABlockAtRestHaveNoFigures) {
  CampaignResults results = boxes_that_stay();
  for (std::size_t i = 3; i < 6; ++i) {
    results.runs[i].result.stop_reason = StopReason::kLeftTerrain;
  }
  const DepositResults deposits = measure_deposits(compared(std::move(results)));
  ASSERT_EQ(deposits.realisations.size(), 2u);
  EXPECT_EQ(deposits.realisations[1].left_terrain, 3u);
  EXPECT_EQ(deposits.realisations[1].mass, 0.0);
  EXPECT_TRUE(std::isnan(deposits.realisations[1].area));
  EXPECT_TRUE(std::isnan(deposits.realisations[1].centre.x()));
  EXPECT_TRUE(deposits.realisations[1].crest.allFinite());
}

TEST(DepositResults, AreNoneWhereNoBlockStayed) {
  const DepositResults deposits = measure_deposits(compared(hand_made_results()));
  EXPECT_TRUE(deposits.realisations.empty());
  EXPECT_TRUE(deposits.rasters.layers.empty());
}

}  // namespace
}  // namespace clast
