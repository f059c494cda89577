#include "reconstruct/deposit/detail/station_views.hpp"

#include <gtest/gtest.h>

#include "reconstruct/deposit/deposit.hpp"
#include "tests/support/balls_on_floor.hpp"

namespace clast {
namespace {

using namespace reconstruct_detail;

constexpr double kFloorSpacing = 0.05;

/// Points of a level floor with upward normals around the origin.
OrientedPoints make_floor() {
  OrientedPoints floor;
  for (int i = -60; i <= 60; ++i) {
    for (int j = -60; j <= 60; ++j) {
      floor.positions.emplace_back(kFloorSpacing * i, kFloorSpacing * j, 0.0);
      floor.normals.push_back(Vec3::UnitZ());
      floor.spacings.push_back(kFloorSpacing);
    }
  }
  floor.spacing = kFloorSpacing;
  return floor;
}

TEST(StationViews, PositionsBetweenStationAndSurfaceAreFree) {
  const OrientedPoints floor = make_floor();
  const std::vector<Vec3> above = {{4.0, 3.0, 2.5}};
  const StationViews views(floor, above);
  EXPECT_TRUE(views.is_free({0.5, 0.5, 0.5}, kFloorSpacing));
  EXPECT_TRUE(views.is_free({-1.0, 0.2, 0.3}, kFloorSpacing));
  EXPECT_FALSE(views.is_free({0.5, 0.5, 0.01}, kFloorSpacing));     // at the surface
  EXPECT_FALSE(views.is_free({0.5, 0.5, -0.5}, kFloorSpacing));     // behind it
  EXPECT_FALSE(views.is_free({-40.0, -30.0, 1.0}, kFloorSpacing));  // no points in this direction
}

TEST(StationViews, ASurfaceSeenFromBehindShowsNoFreeSpace) {
  const OrientedPoints floor = make_floor();
  const std::vector<Vec3> below = {{0.3, 0.2, -3.0}};
  EXPECT_FALSE(StationViews(floor, below).is_free({0.2, 0.1, -1.0}, kFloorSpacing));
}

TEST(StationViews, PointsInFrontHideWhatIsBehind) {
  OrientedPoints floor = make_floor();
  for (int i = -20; i <= 20; ++i) {  // a shelf at height 1
    for (int j = -20; j <= 20; ++j) {
      floor.positions.emplace_back(kFloorSpacing * i, kFloorSpacing * j, 1.0);
      floor.normals.push_back(Vec3::UnitZ());
      floor.spacings.push_back(kFloorSpacing);
    }
  }
  const std::vector<Vec3> above = {{0.0, 0.0, 4.0}};
  const StationViews views(floor, above);
  EXPECT_FALSE(views.is_free({0.1, 0.1, 0.5}, kFloorSpacing));
  EXPECT_TRUE(views.is_free({0.1, 0.1, 1.5}, kFloorSpacing));
  EXPECT_TRUE(views.is_free({1.6, 1.7, 0.5}, kFloorSpacing));
}

TEST(StationViews, OfManyStationsSomeFarFromEachOtherAreUsed) {
  const OrientedPoints floor = make_floor();
  std::vector<Vec3> stations(40, Vec3(0.0, 0.0, -5.0));  // below the floor
  stations.emplace_back(2.0, 2.0, 4.0);
  EXPECT_TRUE(StationViews(floor, stations).is_free({0.5, 0.5, 0.5}, kFloorSpacing));
  EXPECT_TRUE(StationViews(floor, {}).is_empty());
}

/// A ball on a floor of which only the side towards a station at +x is scanned.
TEST(StationViews, BodiesDoNotReachIntoTheFreeSpaceOfStations) {
  const FloorBall ball = {{0.0, 0.0, 0.5}, 0.5};
  const std::vector<Vec3> stations = {{6.0, 0.0, 1.5}, {0.0, 7.0, 1.0}, {0.0, -7.0, 1.0}};
  std::vector<Vec3> points = balls_on_floor({ball}, 3.0, 0.03, 5);
  std::erase_if(points, [&](const Vec3& p) {
    const bool on_ball = (p - ball.centre).norm() < 0.52;
    return on_ball && (p - ball.centre).dot(stations[0] - p) < 0.0;
  });
  const Deposit blind = segment_deposit(points);
  const Deposit seen = segment_deposit(points, {.stations = stations});
  ASSERT_EQ(blind.blocks.size(), 1u);
  ASSERT_EQ(seen.blocks.size(), 1u);
  EXPECT_EQ(seen.blocks[0].points, blind.blocks[0].points);
  const auto widest = [](const TriangleMesh& body) {
    double y = 0.0;
    for (const Vec3& v : body.vertices) y = std::max(y, std::abs(v.y()));
    return y;
  };
  EXPECT_LT(widest(seen.blocks[0].body), ball.radius + 0.1);
  EXPECT_LE(signed_volume(seen.blocks[0].body), signed_volume(blind.blocks[0].body));
}

}  // namespace
}  // namespace clast
