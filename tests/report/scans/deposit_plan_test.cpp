#include "report/scans/deposit_plan.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/random.hpp"
#include "mesh/plan_geometry.hpp"

namespace clast::report_detail {
namespace {

/// Points of a square grid with a spacing of 0.1 m in [0, 10] x [0, 5].
struct GridScene {
  GridScene() {
    for (int i = 0; i <= 100; ++i) {
      for (int j = 0; j <= 50; ++j) {
        const Vec2 plan(0.1 * i, 0.1 * j);
        const bool on_block = (plan - Vec2(3.0, 2.0)).norm() < 1.0;
        points.push_back({plan.x(), plan.y(), on_block ? 1.0 : 0.0});
        blocks.push_back(on_block ? 7 : 0);
      }
    }
  }
  std::vector<Vec3> points;
  std::vector<std::uint32_t> blocks;
};

std::size_t cell_at(const DepositPlan& plan, double x, double y) {
  const auto column = static_cast<std::size_t>((x - plan.window.low.x()) / plan.relief.cell);
  const auto row = static_cast<std::size_t>((plan.window.high.y() - y) / plan.relief.cell);
  return row * plan.relief.columns + column;
}

TEST(DepositPlan, HasHeightAndBlockOfTheHighestPoints) {
  GridScene scene;
  scene.points.push_back({6.0, 4.0, 2.0});  // above the ground
  scene.blocks.push_back(9);
  const DepositPlan plan = make_deposit_plan(scene.points, scene.blocks, 0.1);
  EXPECT_EQ(plan.blocks[cell_at(plan, 3.0, 2.0)], 7u);
  EXPECT_EQ(plan.relief.height[cell_at(plan, 3.0, 2.0)], 1.0);
  EXPECT_EQ(plan.blocks[cell_at(plan, 8.0, 2.0)], 0u);
  EXPECT_EQ(plan.relief.height[cell_at(plan, 8.0, 2.0)], 0.0);
  EXPECT_EQ(plan.blocks[cell_at(plan, 6.0, 4.0)], 9u);
  EXPECT_LE(plan.window.low.x(), 0.0);
  EXPECT_GE(plan.window.high.y(), 5.0);
  std::size_t of_block = 0;
  for (const std::uint32_t block : plan.blocks) of_block += block == 7;
  const double area = static_cast<double>(of_block) * plan.relief.cell * plan.relief.cell;
  EXPECT_NEAR(area, kPi, 0.15 * kPi);
}

TEST(DepositPlan, LeavesStraysOutOfItsWindow) {
  GridScene scene;
  scene.points.push_back({5000.0, -800.0, 3.0});
  scene.blocks.push_back(0);
  const DepositPlan plan = make_deposit_plan(scene.points, scene.blocks, 0.1);
  EXPECT_LT(plan.window.high.x(), 11.0);
  EXPECT_GT(plan.window.low.y(), -1.0);
}

TEST(DepositPlan, OfALargeCloudHasABoundedNumberOfCells) {
  std::vector<Vec3> points;
  Random random(3);
  for (int i = 0; i < 20000; ++i) {
    points.push_back({random.uniform(0.0, 900.0), random.uniform(0.0, 20.0), 0.0});
  }
  const DepositPlan plan =
      make_deposit_plan(points, std::vector<std::uint32_t>(points.size(), 0), 0.002);
  EXPECT_LT(plan.blocks.size(), 800000u);
  EXPECT_TRUE(render_plan_png(plan).starts_with("\x89PNG"));
}

TEST(PlanOutlines, GoAroundTheirPoints) {
  Random random(1);
  std::vector<Vec2> disc;
  while (disc.size() < 4000) {
    const Vec2 p(random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0));
    if (p.norm() < 1.0) disc.push_back(p + Vec2(652000.0, 5203000.0));
  }
  const std::vector<std::vector<Vec2>> outlines = trace_plan_outlines(disc, 0.05);
  ASSERT_EQ(outlines.size(), 1u);
  EXPECT_NEAR(signed_area(outlines[0]), kPi, 0.1 * kPi);
  for (const Vec2& corner : outlines[0]) {
    EXPECT_NEAR((corner - Vec2(652000.0, 5203000.0)).norm(), 1.0, 0.1);
  }
  std::size_t outside = 0;
  for (const Vec2& p : disc) outside += !clast::is_inside(outlines[0], p);
  EXPECT_LT(outside, disc.size() / 100);
}

TEST(PlanOutlines, OfSeparatePartsAreSeparateAndTheLargestIsFirst) {
  std::vector<Vec2> points;
  for (int i = 0; i < 20; ++i) {
    for (int j = 0; j < 20; ++j) {
      points.push_back({0.1 * i, 0.1 * j});
      if (i < 10) points.push_back({5.0 + 0.1 * i, 0.1 * j});
      if (i < 2 && j < 2) points.push_back({9.0 + 0.1 * i, 0.1 * j});  // too small to be drawn
    }
  }
  const std::vector<std::vector<Vec2>> outlines = trace_plan_outlines(points, 0.1);
  ASSERT_EQ(outlines.size(), 2u);
  EXPECT_NEAR(signed_area(outlines[0]), 4.0, 0.5);
  EXPECT_NEAR(signed_area(outlines[1]), 2.0, 0.4);
  EXPECT_TRUE(trace_plan_outlines({}, 0.1).empty());
}

TEST(PlanOutlines, OfCellsThatMeetAtACornerAreClosed) {
  // Two squares that touch at a corner: whichever way, the areas are theirs.
  std::vector<Vec2> points;
  for (int i = 0; i < 10; ++i) {
    for (int j = 0; j < 10; ++j) {
      points.push_back({i + 0.5, j + 0.5});
      points.push_back({i + 10.5, j + 10.5});
    }
  }
  double area = 0.0;
  for (const std::vector<Vec2>& outline : trace_plan_outlines(points, 1.0)) {
    area += signed_area(outline);
  }
  EXPECT_NEAR(area, 200.0, 12.0);
}

}  // namespace
}  // namespace clast::report_detail
