// Heaps put together without overlap.
#include "study/simulate/detail/block_packing.hpp"
#include "mesh/plan_geometry.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/error.hpp"
#include "study/campaign/plan_polygon.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/test_worlds.hpp"

namespace clast {
namespace {

using namespace study_detail;

const std::vector<Vec2> kSquare = {{-2, -2}, {2, -2}, {2, 2}, {-2, 2}};

TriangleMesh slope_mesh() {
  TriangleMesh mesh = plane_mesh(10.0, 20);
  for (Vec3& vertex : mesh.vertices) vertex.z() = 0.8 * vertex.x() + 0.1 * std::sin(vertex.y());
  return mesh;
}

TEST(BlockPacking, StacksCubesWhereThereIsRoomForOne) {
  const TerrainSurface terrain = ground(plane_mesh(10.0, 20));
  const RigidBody cube = box(100.0, {0.5, 0.5, 0.5});
  const GroundOverlap overlap(terrain, cube);
  const std::vector<Vec2> narrow = {{0, 0}, {0.75, 0}, {0.75, 0.75}, {0, 0.75}};
  BlockPacking packing(terrain, narrow, 0.25);
  Random random(1);
  for (int i = 0; i < 3; ++i) {
    const auto state = packing.place(cube, overlap, Quat::Identity(), 1.6, random);
    ASSERT_TRUE(state);
    EXPECT_NEAR(state->position.z(), 0.25 + 0.5 * i, 1e-9);
    EXPECT_EQ(state->velocity, Vec3::Zero());
  }
  EXPECT_NEAR(packing.heap_extent().area, 0.75 * 0.75, 1e-12);
  EXPECT_NEAR(packing.heap_extent().largest_thickness, 1.5, 1e-9);
  EXPECT_FALSE(packing.place(cube, overlap, Quat::Identity(), 1.6, random));
  EXPECT_TRUE(packing.place(cube, overlap, Quat::Identity(), {}, random));
  packing.clear();
  EXPECT_EQ(packing.heap_extent().largest_thickness, 0.0);
  EXPECT_NEAR(packing.place(cube, overlap, Quat::Identity(), {}, random)->position.z(), 0.25, 1e-9);
}

// Concave rocks of three sizes on a slope: the dynamics finds none inside another or the ground.
TEST(BlockPacking, LeavesRocksClearOfEachOtherAndOfTheGround) {
  const TerrainSurface terrain = ground(slope_mesh());
  std::vector<RigidBody> shapes;
  for (const double size : {0.5, 0.7, 1.0}) {
    shapes.push_back(rock(3, {0.5 * size, 0.35 * size, 0.25 * size}, 0.02, 2700.0, 7));
  }
  BlockPacking packing(terrain, kSquare, 0.05);
  Random random(4);
  WorldSettings settings = stiff_world(shapes[0], 1e7);
  World world(shapes, settings, terrain, {{0.1, 0.5, 0.2}});
  double volume = 0.0;
  for (std::size_t i = 0; i < 90; ++i) {
    const std::size_t shape = i % 3;
    const GroundOverlap overlap(terrain, shapes[shape]);
    const auto state =
        packing.place(shapes[shape], overlap, random.rotation(), std::nullopt, random);
    ASSERT_TRUE(state);
    for (const Vec3& vertex : shapes[shape].shape.vertices) {
      EXPECT_TRUE(is_inside(kSquare, (state->world_from_body() * vertex).head<2>()));
    }
    volume += shapes[shape].mass / 2700.0;
    world.add_body(shape, *state);
  }
  EXPECT_NO_THROW(world.step());  // it refuses bodies that overlap at the start
  EXPECT_LT(world.statistics().max_overlap, 0.5e-3 * shapes[2].size());
  const HeapExtent filling = packing.heap_extent();
  EXPECT_GT(volume / (filling.area * filling.mean_thickness), 0.3);
  EXPECT_LT(filling.largest_thickness, 3.0 * filling.mean_thickness);  // a slab, not a tower
}

TEST(BlockPacking, IsTheSameForTheSameDraws) {
  const TerrainSurface terrain = ground(slope_mesh());
  const RigidBody body = rock(3, {0.5, 0.35, 0.25}, 0.02, 2700.0, 7);
  const GroundOverlap overlap(terrain, body);
  const auto heap = [&](BlockPacking& packing, std::uint64_t seed) {
    Random random(seed);
    packing.clear();
    std::vector<Vec3> places;
    for (int i = 0; i < 10; ++i) {
      places.push_back(packing.place(body, overlap, random.rotation(), {}, random)->position);
    }
    return places;
  };
  BlockPacking packing(terrain, kSquare, 0.1), other(terrain, kSquare, 0.1);
  const std::vector<Vec3> first = heap(packing, 5);
  EXPECT_NE(heap(packing, 6), first);
  EXPECT_EQ(heap(packing, 5), first);
  EXPECT_EQ(heap(other, 5), first);
}

TEST(BlockPacking, RefusesOutlinesWithoutRoom) {
  const TerrainSurface terrain = ground(plane_mesh(10.0, 20));
  const auto refused = [&](const std::vector<Vec2>& outline) {
    return refusal([&] { BlockPacking(terrain, outline, 0.1); });
  };
  EXPECT_TRUE(contains(refused({{0, 0}, {1, 1}, {2, 2}}), "has no area"));
  EXPECT_TRUE(contains(refused({{8, 0}, {12, 0}, {12, 2}}), "beyond the terrain"));
  EXPECT_TRUE(contains(refused({{0, 0}, {0.02, 0}, {0.02, 0.02}}), "too narrow"));
  const RigidBody large = box(100.0, {5.0, 1.0, 1.0});
  BlockPacking packing(terrain, kSquare, 0.1);
  Random random(1);
  EXPECT_FALSE(packing.place(large, GroundOverlap(terrain, large), Quat::Identity(), {}, random));
}

}  // namespace
}  // namespace clast
