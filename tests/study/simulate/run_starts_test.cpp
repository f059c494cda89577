// Blocks that would start in the ground start in touch.
#include "study/simulate/detail/run_starts.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/test_bodies.hpp"
#include "tests/support/test_rock.hpp"

namespace clast::study_detail {
namespace {

RigidBody body_of_kind(int kind, std::uint64_t seed) {
  switch (kind) {
    case 0:
      return ball(100.0, 0.4);
    case 1:
      return box(500.0, {1.0, 0.8, 0.6});
    case 2:
      return box(500.0, {1.5, 0.5, 0.3}, 0.08);
    default:
      return rock(3, {0.5, 0.4, 0.3}, 0.03, 2650.0, seed);
  }
}

/// Planes of every slope, rough ones, and a ridge.
TerrainSurface ground_of_kind(int kind) {
  if (kind < 8) return ground(plane_mesh(20.0, 9, kind * 10.0 * kPi / 180.0));
  if (kind < 12) return ground(rough_slope(40, 0.5, 0.15 * (kind - 8), 0.15, kind));
  TriangleMesh ridge;
  ridge.vertices = {{-20, -20, -30}, {0, -20, 0}, {20, -20, -30},
                    {-20, 20, -30},  {0, 20, 0},  {20, 20, -30}};
  ridge.triangles = {{0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4}};
  return ground(std::move(ridge));
}

TEST(RunStarts, LiftedBlocksJustTouch) {
  Random random(7);
  int lifted = 0;
  for (int terrain_kind = 0; terrain_kind < 13; ++terrain_kind) {
    const TerrainSurface surface = ground_of_kind(terrain_kind);
    for (int kind = 0; kind < 4; ++kind) {
      for (std::uint64_t seed = 1; seed <= 4; ++seed) {
        const RigidBody body = body_of_kind(kind, seed);
        const GroundOverlap overlap(surface, body);
        RigidState start;
        start.orientation =
            Quat(random.normal(), random.normal(), random.normal(), random.normal());
        start.orientation.normalize();
        const double x = random.uniform(-5.0, 5.0), y = random.uniform(-5.0, 5.0);
        start.position = {x, y, *surface.height_at(x, y, 100.0) + random.uniform(0.0, 0.2)};
        if (!find_depth_in_ground(overlap, surface, body, start)) continue;
        const RigidState before = start;
        ASSERT_TRUE(lift_to_touch_ground(overlap, surface, body, start))
            << terrain_kind << " " << kind;
        ++lifted;
        EXPECT_GT(overlap.max_overlap(start), 0.0);
        EXPECT_LT(overlap.max_overlap(start), 1e-5 * body.smallest_side);
        EXPECT_GT(start.position.z(), before.position.z());
        EXPECT_EQ(start.position.head<2>(), before.position.head<2>());
        start.position.z() += 1e-5 * body.smallest_side;
        EXPECT_EQ(overlap.max_overlap(start), 0.0) << terrain_kind << " " << kind << " " << seed;
      }
    }
  }
  EXPECT_GT(lifted, 150);
}

TEST(RunStarts, BlocksDeepInTheGroundStayWhereTheyAre) {
  const TerrainSurface surface = ground(plane_mesh(20.0, 9));
  const RigidBody body = ball(100.0, 0.4);
  RigidState start;
  start.position = {0.0, 0.0, -5.0};
  EXPECT_FALSE(lift_to_touch_ground(GroundOverlap(surface, body), surface, body, start));
  EXPECT_EQ(start.position.z(), -5.0);
}

}  // namespace
}  // namespace clast::study_detail
