#include "reconstruct/deposit/detail/plan_tiles.hpp"

#include <gtest/gtest.h>

#include "core/random.hpp"

namespace clast::reconstruct_detail {
namespace {

TEST(PlanTiles, EveryPointIsInOneTileAndNoTileHasTooMany) {
  Random random(1);
  std::vector<Vec3> points;
  for (int i = 0; i < 5000; ++i) {
    points.emplace_back(random.normal(), 3.0 * random.normal(), random.uniform(0.0, 9.0));
  }
  for (int i = 0; i < 300; ++i) points.emplace_back(0.5, i % 7, 0.0);  // equal coordinates
  const std::vector<PlanBox> boxes = divide_in_plan(points, 400);
  EXPECT_GE(boxes.size(), points.size() / 400);
  EXPECT_LE(boxes.size(), 4 * points.size() / 400);
  std::vector<int> uses(points.size(), 0);
  for (const PlanBox& box : boxes) {
    const std::vector<std::uint32_t> members = find_points_within(points, box);
    EXPECT_LE(members.size(), 400u);
    for (const std::uint32_t i : members) ++uses[i];
  }
  for (const int count : uses) EXPECT_EQ(count, 1);
}

TEST(PlanTiles, PointsAtOnePlaceAreOneTile) {
  const std::vector<Vec3> points(50, Vec3(1.0, 2.0, 3.0));
  EXPECT_EQ(divide_in_plan(points, 10).size(), 1u);
}

TEST(PlanTiles, OuterSidesAreInfinite) {
  const std::vector<Vec3> points = {{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {2.0, 0.0, 0.0}};
  const std::vector<PlanBox> boxes = divide_in_plan(points, 2);
  ASSERT_EQ(boxes.size(), 2u);
  EXPECT_TRUE(boxes[0].contains({-1e9, 1e9, 0.0}));
  EXPECT_TRUE(boxes[1].expanded(0.25).contains({0.8, 0.0, 0.0}));
  EXPECT_FALSE(boxes[1].expanded(0.25).contains({0.7, 0.0, 0.0}));
}

}  // namespace
}  // namespace clast::reconstruct_detail
