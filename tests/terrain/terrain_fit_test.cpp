// Whether ground, blocks and release points go together; and where a grid's heights are.
#include <gtest/gtest.h>

#include <cmath>

#include "core/files/text_file.hpp"
#include "terrain/terrain_fit.hpp"
#include "tests/support/ground_gap.hpp"
#include "tests/support/test_bodies.hpp"
#include "tests/terrain/ground_samples.hpp"

namespace clast {
namespace {

class TerrainFit : public testing::Test {
 protected:
  Terrain ground(int n = 10, double cell = 1.0) {
    TriangleMesh mesh = squares(n, cell, [](double, double) { return 5.0; });
    for (Vec3& v : mesh.vertices) v += Vec3(652000, 5203000, 0);
    write_mesh(folder_ / "ground.ply", mesh);
    return read_terrain({.surface = {folder_ / "ground.ply"}});
  }
  const ScratchFolder folder_;
};

TEST_F(TerrainFit, BorderDistanceIsThatToTheNearestSide) {
  const Terrain terrain = ground();
  EXPECT_NEAR(border_distance(terrain, Vec2(652003.5, 5203006)), 3.5, 1e-9);
  EXPECT_NEAR(border_distance(terrain, Vec2(652005, 5203009.25)), 0.75, 1e-9);
  EXPECT_NEAR(border_distance(terrain, Vec2(651996, 5202997)), 5.0, 1e-9);
}

TEST_F(TerrainFit, ReleasePointsNearTheBorderAreWarnedOf) {
  const std::vector<Vec3> places = {
      {652005, 5203005, 9}, {652002, 5203005, 9}, {652005, 5203009, 9}};
  EXPECT_EQ(border_warning(ground(), places, 3.0).value_or(""),
            "2 of 3 release points are nearer than 3 m to the border of the ground, the nearest, 1 "
            "m, at x 652005.000, y 5203009.000, z 9.000; blocks may leave the survey there, so "
            "extend it");
  EXPECT_EQ(border_warning(ground(), places, 1.0), std::nullopt);
}

TEST_F(TerrainFit, AReleaseOutsideIsRefused) {
  const std::vector<Vec3> places = {{652005, 5203005, 9}, {652012, 5203005, 9}};
  EXPECT_EQ(
      refusal<Error>([&] { check_positions_over_terrain(ground(), places, "points.xyz"); }),
      "points.xyz: release point 2 at x 652012.000, y 5203005.000, z 9.000 is off the ground, "
      "which lies in x 652000 to 652010, y 5203000 to 5203010 (map, z up); move the point, or "
      "check its map system and up axis");
  EXPECT_EQ(refusal<Error>([&] {
              check_positions_over_terrain(ground(), std::span(places).first(1), "points.xyz");
            }),
            "");
}

TEST_F(TerrainFit, CellsMuchLargerOrSmallerThanTheBlocksAreWarnedOf) {
  const Terrain terrain = ground();  // edges of 1, 1 and 1.41 m
  EXPECT_EQ(edge_length_warning(terrain, 0.4, 0.6), std::nullopt);
  EXPECT_EQ(edge_length_warning(terrain, 0.1, 0.3).value_or(""),
            "the edges of the ground, 1 m (median), are much longer than the blocks, 0.3 m; the "
            "simulated ground is smoother than the real one: survey it at higher resolution, or "
            "represent its roughness by friction");
  EXPECT_EQ(edge_length_warning(terrain, 25.0, 30.0).value_or(""),
            "the edges of the ground, 1 m (median), are much shorter than the blocks, 25 m; runs "
            "take unnecessarily long: use a coarser resolution or a tolerance");
}

// n x n cells make n x n vertices at their centres: n - 1 squares, not n. The highest is a peak, so
// that nothing but that vertex can be touched from above it.
TEST_F(TerrainFit, ABallOverAKnownNodeTouchesAtItsHeight) {
  constexpr int kCells = 12;
  constexpr double kRadius = 0.2, kGap = 0.05;
  const auto peaks = [](double x, double y) {
    const double i = std::round(x / 2.0 - 0.5), j = std::round(y / 2.0 - 0.5);
    return 100.0 + 0.125 * i + 0.25 * j + (i == 7 && j == 4 ? 1.5 : 0.0);
  };
  write_asc(folder_ / "dem.asc", kCells, kCells, 0.0, 0.0, 2.0, peaks);
  const Terrain terrain = read_terrain({.surface = {folder_ / "dem.asc"}});
  EXPECT_EQ(terrain.surface.vertices.size(), 144u);
  EXPECT_EQ(terrain.surface.triangles.size(), 2u * 11 * 11);
  const TerrainSurface surface = make_terrain_surface(terrain);
  for (int j = 0; j < kCells; ++j) {
    for (int i = 0; i < kCells; ++i) {
      const double x = 2.0 * i + 1.0, y = 2.0 * j + 1.0;
      EXPECT_NEAR(surface.height_at(x, y, 0.0).value_or(0.0), peaks(x, y), 1e-12);
    }
  }
  const double x = 2.0 * 7 + 1.0, y = 2.0 * 4 + 1.0, peak = 100.0 + 0.875 + 1.0 + 1.5;
  const RigidBody body = ball(10.0, kRadius);
  RigidState state;
  state.position = {x, y, peak + kRadius + kGap};
  EXPECT_NEAR(ground_gap(surface, body, state, 1.0).value_or(-1.0), kGap, 1e-12);
  state.position.z() = peak + kRadius;
  EXPECT_NEAR(ground_gap(surface, body, state, 1.0).value_or(-1.0), 0.0, 1e-12);
  // Half a cell off, as the corner registration would have it, it is far from touching.
  state.position += Vec3(1.0, 1.0, 0.0);
  EXPECT_GT(ground_gap(surface, body, state, 3.0).value_or(3.0), 0.3);
  EXPECT_FALSE(surface.covers(0.5, 0.5)) << "half a cell at the border is not known";
}

TEST_F(TerrainFit, BarriersComeFromLineFiles) {
  write_text_file(folder_ / "nets.geojson",
                  R"({"type":"FeatureCollection","features":[{"type":"Feature","properties":{},)"
                  R"("geometry":{"type":"MultiLineString","coordinates":[[[652001,5203001],)"
                  R"([652004,5203002],[652007,5203001]],[[652011,5203001],[652012,5203002]]]}}]})");
  const auto lines = read_barrier_lines(folder_ / "nets.geojson", ground());
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_EQ(lines[0].size(), 3u);
  EXPECT_EQ(lines[0][1], Vec2(652004, 5203002));
}

}  // namespace
}  // namespace clast
