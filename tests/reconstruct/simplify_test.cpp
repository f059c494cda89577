#include "reconstruct/simplify.hpp"

#include <gtest/gtest.h>

#include <array>

#include "core/error.hpp"
#include "mesh/mesh_topology.hpp"
#include "mesh/self_intersection.hpp"
#include "tests/shapes/shape_samples.hpp"
#include "tests/support/refusal.hpp"

namespace clast {
namespace {

TEST(Simplify, AtOrBelowTheTargetNothingChanges) {
  for (const TriangleMesh& mesh : {tetrahedron(), box_mesh({1, 1, 1}), random_rock(1)}) {
    const TriangleMesh same = simplify_mesh(mesh, {.target_vertices = mesh.vertices.size()});
    EXPECT_EQ(same.vertices, mesh.vertices);
    EXPECT_EQ(same.triangles, mesh.triangles);
  }
}

TEST(Simplify, SubdividedBoxBecomesItsEightCorners) {
  const TriangleMesh thin = simplify_mesh(box_mesh({1, 2, 3}, 6), {.target_vertices = 8});
  EXPECT_EQ(thin.vertices.size(), 8u);
  EXPECT_NEAR(enclosed_volume(thin), 6.0, 1e-9);
  EXPECT_NEAR(surface_area(thin), 22.0, 1e-9);
}

TEST(Simplify, MapCoordinatesGiveTheSameShape) {
  const Vec3 offset(888600, 6671300, 200);
  const TriangleMesh rock = random_rock(2, 4);
  const TriangleMesh near = simplify_mesh(rock, {.target_vertices = 100});
  const TriangleMesh far =
      simplify_mesh(transformed(rock, Pose{offset, Quat::Identity()}), {.target_vertices = 100});
  EXPECT_EQ(far.vertices.size(), near.vertices.size());
  EXPECT_NEAR(enclosed_volume(far) / enclosed_volume(near), 1.0, 1e-3);
}

TEST(Simplify, SameInputGivesTheSameBits) {
  const TriangleMesh rock = random_rock(3, 4);
  const TriangleMesh a = simplify_mesh(rock), b = simplify_mesh(rock);
  EXPECT_EQ(a.vertices, b.vertices);
  EXPECT_EQ(a.triangles, b.triangles);
}

TEST(Simplify, OpenMeshAndTinyTargetAreRefused) {
  TriangleMesh open = random_rock(4);
  open.triangles.pop_back();
  EXPECT_THROW(simplify_mesh(open, {.target_vertices = 50}), GeometryError);
  EXPECT_THROW(simplify_mesh(random_rock(4), {.target_vertices = 3}), InputError);
}

TEST(Simplify, SurfaceThatPassesThroughItselfIsRefused) {
  // One box pulled through another: a corner of a box pushed out of the opposite face.
  TriangleMesh box = box_mesh({1, 1, 1}, 8);
  for (Vec3& v : box.vertices) {
    if (v.z() == 1.0 && (v - Vec3(0.5, 0.5, 1)).norm() < 0.3) v.z() = -1.0;
  }
  EXPECT_FALSE(find_self_intersections(box).empty());
  try {
    simplify_mesh(box, {.target_vertices = 200});
    FAIL();
  } catch (const GeometryError& error) {
    EXPECT_NE(std::string(error.what()).find("the scan also intersects itself"), std::string::npos);
  }
}

/// A rock with a straight tube through it, as wide as a triangle, between two of its faces.
TriangleMesh pierced(TriangleMesh rock, std::size_t first, std::size_t second) {
  const TriangleMesh::Triangle a = rock.triangles[first], b = rock.triangles[second];
  rock.triangles.erase(rock.triangles.begin() + static_cast<std::ptrdiff_t>(second));
  rock.triangles.erase(rock.triangles.begin() + static_cast<std::ptrdiff_t>(first));
  // Seen along the tube the two mouths turn against each other.
  const std::array<std::uint32_t, 3> mouth = {b[0], b[2], b[1]};
  std::size_t turn = 0;
  double shortest = 1e300;
  for (std::size_t k = 0; k < 3; ++k) {
    double sum = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
      sum += (rock.vertices[a[i]] - rock.vertices[mouth[(i + k) % 3]]).squaredNorm();
    }
    if (sum < shortest) shortest = sum, turn = k;
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const std::uint32_t c = mouth[(i + turn) % 3], d = mouth[(j + turn) % 3];
    rock.triangles.push_back({a[i], a[j], d});
    rock.triangles.push_back({a[i], d, c});
  }
  return rock;
}

TEST(Simplify, TunnelTooNarrowForTheVerticesIsClosed) {
  const TriangleMesh rock = pierced(random_rock(7, 5, 0.02), 3, 700);
  ASSERT_TRUE(find_self_intersections(rock).empty());
  ASSERT_EQ(inspect_mesh(rock).euler_characteristic, 0);
  const TriangleMesh thin = simplify_mesh(rock, {.target_vertices = 60});
  const MeshReport report = inspect_mesh(thin);
  EXPECT_TRUE(report.is_closed() && report.is_oriented()) << report.summary();
  EXPECT_EQ(report.euler_characteristic, 2);
  EXPECT_LE(thin.vertices.size(), 120u);
  EXPECT_TRUE(find_self_intersections(thin).empty());
  EXPECT_NEAR(enclosed_volume(thin) / enclosed_volume(rock), 1.0, 0.01);
}

TEST(Simplify, FansThatWouldTakeHoursAreRefused) {
  const TriangleMesh fans = spindle(2000);
  const std::string message =
      refusal<GeometryError>([&] { simplify_mesh(fans, {.target_vertices = 100}); });
  EXPECT_TRUE(contains(message, "2000 triangles meet at one vertex")) << message;
  EXPECT_TRUE(contains(message, "remesh")) << message;
  EXPECT_EQ(simplify_mesh(fans, {.target_vertices = 2002}).vertices.size(), 2002u);
}

TEST(SelfIntersection, SoundShapesHaveNoneAndAPokedBoxHasSome) {
  EXPECT_TRUE(find_self_intersections(tetrahedron()).empty());
  EXPECT_TRUE(find_self_intersections(box_mesh({1, 1, 1}, 3)).empty());
  TriangleMesh poked = tetrahedron();
  poked.vertices[3] = Vec3(0.2, 0.2, 1.0);
  EXPECT_TRUE(find_self_intersections(poked).empty());
  const TriangleMesh two =
      merged(tetrahedron(), transformed(tetrahedron(), Pose{{0.1, 0.1, 0.1}, Quat::Identity()}));
  EXPECT_FALSE(find_self_intersections(two).empty());
}

class ThinnedRocks : public testing::TestWithParam<int> {};

TEST_P(ThinnedRocks, AreClosedSimpleAndKeepTheVolume) {
  const TriangleMesh rock = random_rock(GetParam(), 4, 0.02);
  for (const std::size_t target : {400u, 120u, 30u}) {
    const TriangleMesh thin = simplify_mesh(rock, {.target_vertices = target});
    const MeshReport report = inspect_mesh(thin);
    EXPECT_TRUE(report.is_closed() && report.is_oriented()) << report.summary();
    EXPECT_EQ(report.euler_characteristic, 2);
    EXPECT_LE(thin.vertices.size(), target);
    EXPECT_GE(thin.vertices.size(), target * 3 / 4);
    EXPECT_TRUE(find_self_intersections(thin).empty());
    EXPECT_NEAR(enclosed_volume(thin) / enclosed_volume(rock), 1.0, 1e-3);
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, ThinnedRocks, testing::Range(0, 8));

}  // namespace
}  // namespace clast
