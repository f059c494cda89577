// Meshes made into grids of a size.
#include <gtest/gtest.h>

#include <cmath>

#include "terrain/terrain_file.hpp"
#include "tests/terrain/ground_samples.hpp"

namespace clast {
namespace {

class Resampling : public testing::Test {
 protected:
  Terrain read(const TriangleMesh& mesh, double cell) {
    write_mesh(folder_ / "ground.ply", mesh);
    return read_terrain({.surface = {folder_ / "ground.ply"}, .resolution = cell});
  }
  const ScratchFolder folder_;
};

// Centres lie half a cell off multiples of the cell: over 0 to 20 m there are 20 / cell of them,
// and one square less between.
TEST_F(Resampling, APlaneStaysAPlaneAtTheCentresOfCells) {
  const SlopedGround plane;
  TriangleMesh mesh = squares(10, 2.0, [&](double x, double y) { return plane.at(x, y); });
  for (const double cell : {0.5, 1.0, 4.0}) {
    const Terrain terrain = read(mesh, cell);
    const auto n = static_cast<std::size_t>(std::lround(20.0 / cell));
    EXPECT_EQ(terrain.surface.vertices.size(), n * n);
    EXPECT_EQ(terrain.surface.triangles.size(), 2 * (n - 1) * (n - 1));
    EXPECT_EQ(terrain.report.boundary_edges, 4 * (n - 1));
    EXPECT_EQ(terrain.report.components, 1u);
    for (const Vec3& v : terrain.surface.vertices) {
      EXPECT_NEAR(v.z(), plane.at(v.x(), v.y()), 1e-12);
      EXPECT_NEAR(v.x() / cell - std::floor(v.x() / cell), 0.5, 1e-9);
    }
    EXPECT_TRUE(contains(terrain.report.notes.back(),
                         "of 400 m2 in plan; vertices of the mesh are "
                         "up to "));
  }
  EXPECT_TRUE(contains(read(mesh, 2.0).report.notes.back(),
                       "resampled to cells of 2 m: 162 triangles for 200, over 324 of 400 m2"));
}

// A ridge of 3 m between centres 1 m and 3 m beside it is cut by as much as it falls over 1 m.
TEST_F(Resampling, WhatIsLostIsSaid) {
  const auto ridge = [](double x, double) { return 3.0 - std::abs(x - 8.0); };
  const Terrain terrain = read(squares(16, 1.0, ridge), 2.0);
  EXPECT_TRUE(contains(terrain.report.notes.back(), "are up to 1 m above or below it, as at x 8.0"))
      << terrain.report.notes.back();
}

TEST_F(Resampling, ZonesOfFilesAreCarriedOver) {
  const auto level = [](double, double) { return 5.0; };
  TriangleMesh left = squares(10, 1.0, level), right = squares(10, 1.0, level);
  for (Vec3& v : right.vertices) v.x() += 10.0;
  write_mesh(folder_ / "left.ply", left);
  write_mesh(folder_ / "right.ply", right);
  const Terrain terrain = read_terrain({.surface = {folder_ / "left.ply", folder_ / "right.ply"},
                                        .zones = {"rock", "grass"},
                                        .resolution = 0.8});
  double area[2] = {0.0, 0.0};
  for (std::size_t t = 0; t < terrain.zone.size(); ++t) {
    const auto& [a, b, c] = terrain.surface.triangles[t];
    const std::vector<Vec3>& v = terrain.surface.vertices;
    const double middle = (v[a].x() + v[b].x() + v[c].x()) / 3.0;
    area[terrain.zone[t]] += normal_of(terrain, t).z() / 2.0;
    // Centres at 9.2 and 10.0 m: all of these triangles lie left of the border.
    EXPECT_EQ(terrain.zone_names[terrain.zone[t]], middle < 10.0 ? "rock" : "grass") << middle;
  }
  EXPECT_NEAR(area[0], 9.6 * 9.6, 1e-9);  // centres from 0.4 to 10 m, both ways
  EXPECT_NEAR(area[1], 9.6 * 9.6, 1e-9);
}

TEST_F(Resampling, HolesStay) {
  TriangleMesh mesh = squares(20, 1.0, [](double x, double) { return 0.1 * x; });
  std::erase_if(mesh.triangles, [&](const TriangleMesh::Triangle& t) {
    const Vec3 middle = (mesh.vertices[t[0]] + mesh.vertices[t[1]] + mesh.vertices[t[2]]) / 3.0;
    return (middle.head<2>() - Vec2(10, 10)).cwiseAbs().maxCoeff() < 4.0;
  });
  const Terrain terrain = read(mesh, 0.5);
  // 16 x 16 centres without ground: the border goes around 17 x 17 squares of the grid.
  EXPECT_EQ(terrain.report.boundary_edges, 4u * 39 + 4u * 17);
}

TEST_F(Resampling, WallsAndOverhangsAreRefusedWithTheirPlace) {
  TriangleMesh mesh = squares(6, 1.0, [](double, double) { return 0.0; });
  for (Vec3& v : mesh.vertices) {
    if (v.x() >= 4.0) v += Vec3(-1.5, 0.0, 3.0);
  }
  write_mesh(folder_ / "cliff.ply", mesh);
  const std::string message =
      refusal(TerrainOptions{.surface = {folder_ / "cliff.ply"}, .resolution = 0.5});
  EXPECT_TRUE(
      contains(message, "cliff.ply: 12 of 72 triangles are vertical or overhang, the first"))
      << message;
  EXPECT_TRUE(contains(message, " at x ") &&
              contains(message, "simplify the mesh with a tolerance"));
}

// Tiles of two sizes meet in steps of centimetres that were filled upright: no cell shows them.
TEST_F(Resampling, WallsLowerThanACellAreNoHindrance) {
  const auto wavy = [](double, double y) { return 0.2 * std::sin(y); };
  TriangleMesh coarse = squares(10, 1.0, wavy), fine = squares(20, 0.5, wavy);
  for (Vec3& v : fine.vertices) v.x() += 10.0;
  write_mesh(folder_ / "coarse.ply", coarse);
  write_mesh(folder_ / "fine.ply", fine);
  const Terrain terrain =
      read_terrain({.surface = {folder_ / "coarse.ply", folder_ / "fine.ply"}, .resolution = 0.5});
  EXPECT_EQ(terrain.report.boundary_edges, 2u * (39 + 19));
  EXPECT_EQ(facing_down(terrain), 0u);
}

TEST_F(Resampling, ImpossibleSizesAreRefused) {
  write_mesh(folder_ / "ground.ply", squares(4, 1.0, [](double, double) { return 0.0; }));
  const auto refused = [&](double cell) {
    return refusal(TerrainOptions{.surface = {folder_ / "ground.ply"}, .resolution = cell});
  };
  EXPECT_TRUE(contains(refused(1e-6), "resolution = 1e-06: must be from 0.0001 to 100000 m"));
  write_mesh(folder_ / "wide.ply", squares(4, 1000.0, [](double, double) { return 0.0; }));
  EXPECT_TRUE(
      contains(refusal(TerrainOptions{.surface = {folder_ / "wide.ply"}, .resolution = 1e-3}),
               "too many; use a larger `resolution`"));
  EXPECT_TRUE(contains(refused(50.0), "no 2 x 2 neighbouring cells have heights"));
  write_terrain(folder_ / "ground.h5", read_terrain({.surface = {folder_ / "ground.ply"}}));
  EXPECT_TRUE(contains(refusal(TerrainOptions{.surface = {folder_ / "ground.h5"}, .resolution = 2}),
                       "already checked and repaired; leave out resolution"));
}

}  // namespace
}  // namespace clast
