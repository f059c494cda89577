#include "reconstruct/ground/ground.hpp"

#include <gtest/gtest.h>

#include <iostream>

#include "reconstruct/ground/blocks_on_ground.hpp"
#include "tests/support/field_scene.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/rock_mesh.hpp"

namespace clast {
namespace {

double degrees_between(const Vec3& a, const Vec3& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b)) * 180.0 / kPi;
}

/// Wrong labels of one block against the truth, as a share of all points.
double wrong_share(const FieldScene& scene, const BlockOnGround& block, int owner) {
  std::vector<bool> taken(scene.points.size(), false);
  for (const std::uint32_t i : block.points) taken[i] = true;
  std::size_t wrong = 0;
  for (std::size_t i = 0; i < scene.points.size(); ++i) {
    wrong += taken[i] != (scene.owner[i] == owner);
  }
  return static_cast<double>(wrong) / static_cast<double>(scene.points.size());
}

FieldScene rock_on_slope(const FieldGround& ground, const FieldCounts& counts, std::uint64_t seed) {
  const TriangleMesh rock =
      buried_at(rock_mesh(12, {0.4, 0.33, 0.27}, seed), 0.05, -0.1, 0.06, ground);
  return field_scene({rock}, ground, counts, seed);
}

TEST(Ground, PlaneOfASlopeIsFoundWithItsNormal) {
  const FieldGround slope(0.2, 0.002, 0, 1.0, 1);
  const FieldScene scene = rock_on_slope(slope, {.noise = 0.001}, 1);
  const auto ground = find_ground(scene.points);
  ASSERT_TRUE(ground.has_value());
  EXPECT_LT(degrees_between(ground->plane().normal, Vec3(-0.2, 0.0, 1.0)), 0.2);
  EXPECT_LT(std::abs(ground->plane().signed_distance({0.8, 0.8, 0.16})), 0.003);
  // Gravel of 2 mm and noise of 1 mm along the normal.
  EXPECT_NEAR(ground->roughness(), std::hypot(0.002, 0.001), 0.0007);
}

TEST(Ground, GravelTiltsThePlaneByLessThanADegree) {
  const FieldGround slope(0.15, 0.006, 400, 1.0, 2);
  const FieldScene scene = rock_on_slope(slope, {.noise = 0.001}, 2);
  const auto ground = find_ground(scene.points);
  ASSERT_TRUE(ground.has_value());
  EXPECT_LT(degrees_between(ground->plane().normal, Vec3(-0.15, 0.0, 1.0)), 1.0);
}

TEST(Ground, AGroundWithoutAnyRoughnessIsFoundToo) {
  Random random(6);
  std::vector<Vec3> points;
  for (int i = 0; i < 5000; ++i) points.emplace_back(random.uniform(), random.uniform(), 0.0);
  const auto ground = find_ground(points);
  ASSERT_TRUE(ground.has_value());
  EXPECT_LT(ground->roughness(), 1e-6);
  EXPECT_NEAR(std::abs(ground->plane().normal.z()), 1.0, 1e-9);
}

TEST(Ground, LocalSurfaceFollowsAHollow) {
  // A bowl 10 cm deep over 2 m, five times the tolerance of the plane, without anything on it but a
  // pole that says where up is.
  std::vector<Vec3> points;
  Random random(3);
  const auto bowl = [](double x, double y) { return 0.05 * (x * x + y * y); };
  for (int i = 0; i < 20000; ++i) {
    const double x = random.uniform(-1.0, 1.0), y = random.uniform(-1.0, 1.0);
    points.emplace_back(x, y, bowl(x, y));
  }
  for (int i = 0; i < 2000; ++i) {
    points.emplace_back(0.05 * random.uniform(), 0.05 * random.uniform(), random.uniform(0.0, 0.5));
  }
  const auto ground = find_ground(points);
  ASSERT_TRUE(ground.has_value());
  for (const double x : {-0.8, -0.3, 0.2, 0.9}) {
    EXPECT_NEAR(ground->height_above_ground({x, 0.4, bowl(x, 0.4)}), 0.0, 0.003) << x;
    const Plane below = ground->tangent_plane_below({x, 0.4, 1.0}, 0.1);
    EXPECT_LT(degrees_between(below.normal, Vec3(-0.1 * x, -0.04, 1.0)), 0.7) << x;
    EXPECT_NEAR(below.signed_distance({x, 0.4, bowl(x, 0.4)}), 0.0, 0.003) << x;
  }
}

TEST(Ground, UpIsAwayFromTheGroundWhicheverWayTheScanLies) {
  const FieldGround slope(0.1, 0.002, 0, 1.0, 4);
  FieldScene scene = rock_on_slope(slope, {.noise = 0.001}, 4);
  Random random(5);
  for (int i = 0; i < 3; ++i) {
    const Pose pose{{5e5, 5.2e6, 900.0}, random.rotation()};
    std::vector<Vec3> turned;
    for (const Vec3& p : scene.points) turned.push_back(pose * p);
    const auto ground = find_ground(turned);
    ASSERT_TRUE(ground.has_value());
    const Vec3 up = pose.rotation * Vec3(-0.1, 0.0, 1.0);
    EXPECT_LT(degrees_between(ground->plane().normal, up), 0.5);
  }
}

TEST(Ground, ABlockByItselfHasNone) {
  Random random(6);
  const FieldGround nothing(0.0, 0.0, 0, 1.0, 1);
  for (const Vec3& half_axes : {Vec3(0.4, 0.3, 0.3), Vec3(0.4, 0.35, 0.1), Vec3(0.6, 0.15, 0.15)}) {
    TriangleMesh rock = rock_mesh(12, half_axes, 6);
    for (Vec3& v : rock.vertices) v.z() += 2.0;   // far above the ground of the generator
    for (const double steepest : {-1.0, -0.6}) {  // seen from all sides, and open below
      const FieldScene scene =
          field_scene({rock}, nothing, {.per_block = 20000, .ground = 0, .steepest = steepest}, 6);
      EXPECT_FALSE(find_ground(scene.points).has_value()) << half_axes.transpose() << steepest;
    }
  }
}

TEST(Ground, TooFewPointsHaveNone) {
  EXPECT_FALSE(find_ground({}).has_value());
  EXPECT_FALSE(find_ground(std::vector<Vec3>(10, Vec3::Zero())).has_value());
}

TEST(Ground, OptionsOutOfRangeAreNamed) {
  EXPECT_TRUE(contains(refusal([] { find_ground({}, {.trials = 0}); }), "trials"));
  EXPECT_TRUE(contains(refusal([] { find_ground({}, {.tolerance = 0.5}); }), "tolerance"));
  EXPECT_TRUE(contains(refusal([] { find_ground({}, {.min_block_height = 0.0}); }), "least_rise"));
}

TEST(BlocksOnGround, BlockOnGravelHasHalfAPercentOfWrongPointsAtMost) {
  for (const std::uint64_t seed : {1u, 2u, 3u}) {
    const FieldGround gravel(0.15, 0.006, 400, 1.0, seed);
    const FieldScene scene = rock_on_slope(gravel, {.noise = 0.0007}, seed);
    const auto ground = find_ground(scene.points);
    ASSERT_TRUE(ground.has_value()) << seed;
    const BlocksOnGround standing = find_blocks_on_ground(scene.points, *ground);
    ASSERT_EQ(standing.blocks.size(), 1u) << seed;
    const double wrong = wrong_share(scene, standing.blocks[0], 0);
    std::cout << "gravel " << seed << ": " << 100.0 * wrong << " % wrong\n";
    EXPECT_LE(wrong, 0.005) << seed;
  }
}

TEST(BlocksOnGround, ThreeBlocksAreThreeInOrderOfX) {
  const FieldGround gravel(0.1, 0.004, 200, 2.0, 7);
  const std::vector<TriangleMesh> rocks = {
      buried_at(rock_mesh(10, {0.3, 0.25, 0.2}, 1), 1.1, 0.2, 0.08, gravel),
      buried_at(rock_mesh(10, {0.4, 0.3, 0.3}, 2), -1.2, -0.3, 0.05, gravel),
      buried_at(rock_mesh(10, {0.25, 0.2, 0.2}, 3), 0.0, 0.1, 0.1, gravel)};
  const FieldScene scene = field_scene(
      rocks, gravel, {.per_block = 15000, .ground = 60000, .noise = 0.001, .half = 2.0}, 8);
  const auto ground = find_ground(scene.points);
  ASSERT_TRUE(ground.has_value());
  const BlocksOnGround standing = find_blocks_on_ground(scene.points, *ground);
  ASSERT_EQ(standing.blocks.size(), 3u);
  EXPECT_LE(wrong_share(scene, standing.blocks[0], 1), 0.005);
  EXPECT_LE(wrong_share(scene, standing.blocks[1], 2), 0.005);
  EXPECT_LE(wrong_share(scene, standing.blocks[2], 0), 0.005);
  EXPECT_EQ(standing.central_block, 1u);  // the smallest of all, but in the middle
  const BlocksOnGround again = find_blocks_on_ground(scene.points, *find_ground(scene.points));
  for (int k = 0; k < 3; ++k) EXPECT_EQ(again.blocks[k].points, standing.blocks[k].points);
}

TEST(BlocksOnGround, BareGroundHasNone) {
  const FieldGround gravel(0.1, 0.005, 300, 1.0, 9);
  const FieldScene scene = field_scene({}, gravel, {.ground = 20000, .noise = 0.001}, 9);
  const auto ground = find_ground(scene.points);
  ASSERT_TRUE(ground.has_value());
  const BlocksOnGround standing = find_blocks_on_ground(scene.points, *ground);
  EXPECT_TRUE(standing.blocks.empty());
  EXPECT_EQ(standing.ground.size(), scene.points.size());
}

}  // namespace
}  // namespace clast
