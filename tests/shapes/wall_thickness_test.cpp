#include "shapes/wall_thickness.hpp"

#include <gtest/gtest.h>

#include "tests/shapes/shape_samples.hpp"

namespace clast {
namespace {

TEST(WallThickness, OfABoxIsItsShortestSide) {
  const Pose pose{Vec3(4, -3, 2), Random(3).rotation()};
  const auto wall = find_thinnest_wall(transformed(box_mesh({2, 0.3, 1}, 3), pose));
  ASSERT_TRUE(wall);
  EXPECT_NEAR(wall->thickness, 0.3, 1e-12);
  const Vec3 place = pose.inverse() * wall->position;
  EXPECT_NEAR(place.y(), 0.15, 1e-12);
}

TEST(WallThickness, SharpCornersAreNoWalls) { EXPECT_FALSE(find_thinnest_wall(tetrahedron())); }

TEST(WallThickness, AFinIsFoundWhereItIs) {
  // The middle of one side of a cube pushed to 0.1 before the other.
  TriangleMesh block = box_mesh({1, 1, 1}, 10);
  for (Vec3& v : block.vertices) {
    if (v.z() == 1.0 && std::abs(v.x() - 0.5) < 0.35 && std::abs(v.y() - 0.5) < 0.35) v.z() = 0.1;
  }
  const auto wall = find_thinnest_wall(block);
  ASSERT_TRUE(wall);
  EXPECT_NEAR(wall->thickness, 0.1, 1e-12);
  EXPECT_NEAR(wall->position.z(), 0.05, 1e-12);
  EXPECT_LT((wall->position - Vec3(0.5, 0.5, 0.05)).norm(), 0.5);
}

TEST(WallThickness, NothingHasNone) { EXPECT_FALSE(find_thinnest_wall({})); }

}  // namespace
}  // namespace clast
