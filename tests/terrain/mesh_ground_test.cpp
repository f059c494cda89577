// Meshes as ground: welding, dropping, turning, refusing.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "core/files/text_file.hpp"
#include "core/random.hpp"
#include "tests/terrain/ground_samples.hpp"

namespace clast {
namespace {

double wavy(double x, double y) { return std::sin(x) + 0.5 * std::cos(2.0 * y); }

/// Every triangle with three vertices of its own, as STL has them.
TriangleMesh torn(const TriangleMesh& mesh) {
  TriangleMesh result;
  for (const TriangleMesh::Triangle& t : mesh.triangles) {
    const auto first = static_cast<std::uint32_t>(result.vertices.size());
    for (const std::uint32_t corner : t) result.vertices.push_back(mesh.vertices[corner]);
    result.triangles.push_back({first, first + 1, first + 2});
  }
  return result;
}

class MeshGround : public testing::Test {
 protected:
  Terrain read(const TriangleMesh& mesh, const std::string& up = "z") {
    write_mesh(folder_ / "ground.ply", mesh);
    return read_terrain({.surface = {folder_ / "ground.ply"}, .up = up});
  }
  std::string refused(const TriangleMesh& mesh) {
    write_mesh(folder_ / "ground.ply", mesh);
    return refusal(TerrainOptions{.surface = {folder_ / "ground.ply"}});
  }
  const ScratchFolder folder_;
};

// n x n squares: 2 n^2 triangles, (n + 1)^2 vertices, 4 n border edges.
TEST_F(MeshGround, SquaresComeBackWeldedWithTheirBorder) {
  for (const int n : {1, 2, 7, 30}) {
    const Terrain terrain = read(torn(squares(n, 0.5, wavy)));
    const std::size_t side = static_cast<std::size_t>(n);
    EXPECT_EQ(terrain.surface.triangles.size(), 2 * side * side);
    EXPECT_EQ(terrain.surface.vertices.size(), (side + 1) * (side + 1));
    EXPECT_EQ(terrain.report.triangles_read, 2 * side * side);
    EXPECT_EQ(terrain.report.welded_vertices, 6 * side * side - (side + 1) * (side + 1));
    EXPECT_EQ(terrain.report.boundary_edges, 4 * side);
    EXPECT_EQ(terrain.report.components, 1u);
    EXPECT_EQ(terrain.report.flipped_triangles, 0u);
    EXPECT_EQ(terrain.zone_names, std::vector<std::string>{"ground"});
    EXPECT_EQ(terrain.zone, std::vector<std::uint16_t>(2 * side * side, 0));
    EXPECT_TRUE(terrain.frame.origin.isZero(0.0));
  }
}

TEST_F(MeshGround, OnlyCopiesOfVerticesAreWelded) {
  TriangleMesh mesh = torn(squares(4, 0.5, wavy));
  Random random(5);
  for (Vec3& v : mesh.vertices) v += 2e-7 * random.unit_vector();  // copies, badly rounded
  EXPECT_EQ(read(mesh).surface.vertices.size(), 25u);
  // A real edge of 5 micrometres stays.
  const TriangleMesh thin{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {5e-6, 0, 0}}, {{0, 3, 2}, {3, 1, 2}}};
  EXPECT_EQ(read(thin).surface.vertices.size(), 4u);
}

TEST_F(MeshGround, MixedUpTrianglesAreTurnedUp) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    Random random(seed);
    TriangleMesh mesh = squares(6, 0.5, wavy);
    std::size_t down = 0;
    for (TriangleMesh::Triangle& t : mesh.triangles) {
      if (random.uniform_index(2) == 0) continue;
      std::swap(t[0], t[1]);
      ++down;
    }
    const Terrain terrain = read(mesh);
    EXPECT_EQ(facing_down(terrain), 0u);
    EXPECT_EQ(terrain.report.flipped_triangles, down);
  }
}

TEST_F(MeshGround, PiecesAreTurnedUpEachByItself) {
  TriangleMesh low = squares(3, 0.5, wavy), other = squares(3, 0.5, wavy);
  for (TriangleMesh::Triangle& t : other.triangles) std::swap(t[1], t[2]);
  for (Vec3& v : other.vertices) v.x() += 10.0;
  const Terrain terrain = read(merged(low, other));
  EXPECT_EQ(terrain.report.components, 2u);
  EXPECT_EQ(terrain.report.flipped_triangles, 18u);
  EXPECT_EQ(facing_down(terrain), 0u);
}

// A cliff that leans over: a strip that faces down between two that face up must stay that way.
TEST_F(MeshGround, OverhangsKeepFacingDown) {
  TriangleMesh mesh;
  for (const Vec2& p : {Vec2(0, 10), Vec2(5, 10), Vec2(4, 4), Vec2(12, 3)}) {
    mesh.vertices.emplace_back(p.x(), 0, p.y());
    mesh.vertices.emplace_back(p.x(), 3, p.y());
  }
  for (std::uint32_t k = 0; k < 6; k += 2) {
    mesh.triangles.push_back({k, k + 2, k + 3});
    mesh.triangles.push_back({k + 3, k + 1, k});
  }
  for (TriangleMesh::Triangle& t : mesh.triangles) std::swap(t[1], t[2]);
  const Terrain terrain = read(mesh);
  EXPECT_EQ(terrain.report.flipped_triangles, 6u);
  EXPECT_EQ(facing_down(terrain), 2u);
  EXPECT_TRUE(contains(terrain.report.notes.back(), "2 of 6 triangles overhang: check that z is "));
}

TEST_F(MeshGround, DegenerateTrianglesAndCopiesAreDroppedAndCounted) {
  TriangleMesh mesh = squares(2, 1.0, wavy);
  mesh.triangles.push_back({0, 1, 1});
  mesh.triangles.push_back(mesh.triangles[3]);
  std::swap(mesh.triangles.back()[0], mesh.triangles.back()[2]);
  mesh.vertices.emplace_back(5, 5, 0);
  mesh.vertices.emplace_back(6, 5, 0);
  mesh.vertices.emplace_back(7, 5, 1e-12);
  mesh.triangles.push_back({9, 10, 11});
  const Terrain terrain = read(mesh);
  EXPECT_EQ(terrain.surface.triangles.size(), 8u);
  EXPECT_EQ(terrain.surface.vertices.size(), 9u);
  EXPECT_EQ(terrain.report.removed_degenerate, 2u);
  EXPECT_EQ(terrain.report.removed_duplicates, 1u);
}

TEST_F(MeshGround, YUpIsTurnedZUp) {
  TriangleMesh mesh = squares(3, 1.0, wavy);
  const Terrain expected = read(mesh);
  for (Vec3& v : mesh.vertices) v = Vec3(v.x(), v.z(), -v.y());
  const Terrain terrain = read(mesh, "y");
  ASSERT_EQ(terrain.surface.vertices.size(), expected.surface.vertices.size());
  for (std::size_t i = 0; i < terrain.surface.vertices.size(); ++i) {
    EXPECT_EQ(terrain.surface.vertices[i], expected.surface.vertices[i]);
  }
  EXPECT_EQ(facing_down(terrain), 0u);
}

TEST_F(MeshGround, LargeCoordinatesLoseNoDigitsToTheLocalOrigin) {
  TriangleMesh mesh = squares(4, 0.5, wavy);
  const Vec3 offset(652000.25, 5203000.5, 0.0);
  for (Vec3& v : mesh.vertices) v += offset;
  const Terrain terrain = read(mesh);
  EXPECT_EQ(terrain.frame.origin, Vec3(652001, 5203002, 0));
  EXPECT_LT(bounds(terrain.surface).high.cwiseAbs().maxCoeff(), 3.0);
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    EXPECT_EQ(terrain.frame.to_map(terrain.surface.vertices[i]), mesh.vertices[i]);
  }
}

TEST_F(MeshGround, EdgesOfThreeTrianglesAreRefusedWithTheirPlace) {
  TriangleMesh mesh = squares(2, 1.0, [](double, double) { return 0.0; });
  mesh.vertices.emplace_back(1.5, 0.5, 2.0);
  mesh.triangles.push_back({1, 4, 9});  // stands on the edge from (1, 0) to (1, 1)
  const std::string message = refused(mesh);
  EXPECT_TRUE(contains(message, "1 edges where more than two triangles meet"));
  EXPECT_TRUE(contains(message, "x 1.000, y 0.500"));
}

TEST_F(MeshGround, MoebiusBandIsRefused) {
  TriangleMesh mesh;
  constexpr std::uint32_t n = 12;
  for (std::uint32_t i = 0; i < n; ++i) {
    const double angle = 2.0 * kPi * i / n;
    const Vec3 out(std::cos(angle), std::sin(angle), 0.0);
    const Vec3 across = std::cos(angle / 2) * out + std::sin(angle / 2) * Vec3::UnitZ();
    mesh.vertices.push_back(3.0 * out + across);
    mesh.vertices.push_back(3.0 * out - across);
  }
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t a = 2 * i, b = 2 * i + 1;
    const std::uint32_t c = i + 1 < n ? a + 2 : 1, d = i + 1 < n ? b + 2 : 0;
    mesh.triangles.push_back({a, b, c});
    mesh.triangles.push_back({b, d, c});
  }
  EXPECT_TRUE(contains(refused(mesh), "without an upper side"));
}

TEST_F(MeshGround, WhatIsNoGroundIsRefused) {
  EXPECT_TRUE(contains(refusal(TerrainOptions{}), "surface: no file"));
  EXPECT_TRUE(contains(refusal(TerrainOptions{.surface = {folder_ / "none.stl"}}),
                       "none.stl: no such file"));
  EXPECT_TRUE(contains(refusal(TerrainOptions{.surface = {folder_.path()}}), "is a folder"));
  write_text_file(folder_ / "a.doc", "x");
  EXPECT_TRUE(contains(refusal(TerrainOptions{.surface = {folder_ / "a.doc"}}), "\".doc\""));
  write_text_file(folder_ / "a.las", "LASF");
  EXPECT_TRUE(contains(refusal(TerrainOptions{.surface = {folder_ / "a.las"}}), "LAS header"));
  write_text_file(folder_ / "a.stl", "");
  EXPECT_TRUE(contains(refusal(TerrainOptions{.surface = {folder_ / "a.stl"}}), "a.stl"));
  EXPECT_TRUE(contains(refused({{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}}}), "no ground"));
  write_mesh(folder_ / "b.ply", squares(2, 1.0, wavy));
  write_text_file(folder_ / "c.xyz", "0 0 0\n");
  EXPECT_TRUE(contains(refusal(TerrainOptions{.surface = {folder_ / "b.ply", folder_ / "c.xyz"}}),
                       "can't be mixed"));
  EXPECT_TRUE(
      contains(refusal(TerrainOptions{.surface = {folder_ / "b.ply"}, .up = "x"}), "up = \"x\""));
  EXPECT_TRUE(contains(refusal(TerrainOptions{.surface = {folder_ / "b.ply"}, .resolution = -1.0}),
                       "resolution = -1"));
}

TEST_F(MeshGround, VerticesThatAreNotNumbersAreRefused) {
  TriangleMesh mesh = squares(2, 1.0, wavy);
  mesh.vertices[4].z() = std::numeric_limits<double>::quiet_NaN();
  write_mesh(folder_ / "nan.ply", mesh);
  EXPECT_TRUE(contains(refusal(TerrainOptions{.surface = {folder_ / "nan.ply"}}), "nan.ply"));
}

TEST_F(MeshGround, GroundInOtherUnitsOrOnItsSideIsNoted) {
  TriangleMesh mesh = squares(2, 0.1, wavy);
  EXPECT_TRUE(
      contains(read(mesh).report.notes.front(), "check that its coordinates are in metres"));
  mesh = squares(4, 1.0, [](double x, double) { return 20.0 * x; });
  EXPECT_TRUE(contains(read(mesh).report.notes.front(), "check that z is its upward axis"));
}

}  // namespace
}  // namespace clast
