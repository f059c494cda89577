/// What a scan leaves open of a block is stated with it, and holds the truth.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "massprops/solid.hpp"
#include "mesh/mesh_topology.hpp"
#include "reconstruct/cloud/cloud_surface.hpp"
#include "reconstruct/cloud/detail/poisson.hpp"
#include "reconstruct/field_scan.hpp"
#include "reconstruct/underside/noted_bounds.hpp"
#include "shapes/oriented_box.hpp"
#include "tests/support/rock_mesh.hpp"
#include "tests/support/sampled_cloud.hpp"
#include "tests/support/test_bodies.hpp"

namespace clast {
namespace {

double volume_of(const TriangleMesh& mesh) { return solid_mass_properties(mesh, 1.0).volume; }

/// An octahedron drawn out to a needle 2 m long with two sharp tips, of many triangles.
TriangleMesh needle(double thickness = 0.2) {
  TriangleMesh mesh = geodesic_sphere(24);
  for (Vec3& v : mesh.vertices) {
    v /= v.cwiseAbs().sum();
    v.y() *= 0.5 * thickness;
    v.z() *= 0.5 * thickness;
  }
  return mesh;
}

void expect_holds(const VolumeBracket& bounds, const TriangleMesh& truth) {
  const double volume = volume_of(truth);
  EXPECT_LE(bounds.lower_volume, volume);
  ASSERT_TRUE(bounds.upper_volume && bounds.sides);
  EXPECT_GE(*bounds.upper_volume, volume);
  const Vec3 sides = smallest_box(truth.vertices).lengths;
  for (int k = 0; k < 3; ++k) {
    EXPECT_LE(bounds.sides->lower[k], sides[k]) << k;
    EXPECT_GE(bounds.sides->upper[k], sides[k]) << k;
  }
}

TEST(NotedBounds, OfASparseCloudHoldTheBody) {
  for (const TriangleMesh& body :
       {needle(0.6), rock_mesh(16, {0.5, 0.4, 0.06}, 3), geodesic_sphere(20)}) {
    const auto blocks = extract_field_blocks(sampled_cloud(body, {.points = 1500}, 3), "cloud");
    ASSERT_EQ(blocks.size(), 1u);
    ASSERT_TRUE(blocks[0].bounds.has_value());
    expect_holds(*blocks[0].bounds, body);
  }
}

TEST(NotedBounds, OfANoisyCloudHoldTheBody) {
  const TriangleMesh plank = rock_mesh(16, {0.5, 0.2, 0.06}, 3);
  const auto blocks =
      extract_field_blocks(sampled_cloud(plank, {.points = 6000, .noise = 0.005}, 3), "cloud");
  ASSERT_TRUE(blocks[0].bounds.has_value());
  expect_holds(*blocks[0].bounds, plank);
}

TEST(NotedBounds, NarrowWithTheNumberOfPoints) {
  // Of a ball n points cut off a share of the volume proportional to 1/n.
  const auto width = [](std::size_t points) {
    const SurfaceUncertainty uncertainty =
        fit_cloud_surface(sampled_cloud(geodesic_sphere(40), {.points = points}, 3)).uncertainty;
    return uncertainty.volume_above;
  };
  EXPECT_NEAR(width(2000) / width(8000), 4.0, 1.0);
}

TEST(NotedBounds, OfATipLostInASmallHoleReachToWhereItsFlanksMeet) {
  const TriangleMesh whole = needle();
  TriangleMesh open = whole;
  std::erase_if(open.triangles, [&](const TriangleMesh::Triangle& t) {
    return std::any_of(t.begin(), t.end(), [&](auto v) { return whole.vertices[v].x() > 0.93; });
  });
  const auto blocks = extract_field_blocks(open, "needle");
  ASSERT_TRUE(blocks[0].bounds.has_value());
  expect_holds(*blocks[0].bounds, whole);
  EXPECT_LT(blocks[0].bounds->sides->upper[0], 2.1);
}

// The end of a needle that stands in the ground: so narrow that its rim has few points. Among the
// fewest it looks like any other gap between points.
TEST(NotedBounds, OfTheEndThatACloudHasNoPointsOfHoldTheBody) {
  const TriangleMesh whole = rock_mesh(16, {0.5, 0.08, 0.06}, 3);
  const double end = bounds(whole).low.x() + 0.08;
  for (const std::size_t count : {1500u, 4000u, 12000u}) {
    std::vector<Vec3> points = sampled_cloud(whole, {.points = count}, 3);
    std::erase_if(points, [&](const Vec3& p) { return p.x() < end; });
    const auto blocks = extract_field_blocks(points, "needle");
    ASSERT_TRUE(blocks[0].bounds.has_value()) << count;
    EXPECT_EQ(blocks[0].underside.has_value(), count > 1500u) << count;
    expect_holds(*blocks[0].bounds, whole);
  }
}

TEST(NotedBounds, OfASoundMeshAreNone) {
  EXPECT_FALSE(
      extract_field_blocks(rock_mesh(12, {0.5, 0.4, 0.3}, 3), "rock")[0].bounds.has_value());
}

TEST(NotedBounds, OfAHoleThatMattersToNobodyAreNone) {
  TriangleMesh rock = rock_mesh(40, {0.5, 0.4, 0.3}, 3);
  rock.triangles.erase(rock.triangles.begin() + 100);
  EXPECT_FALSE(extract_field_blocks(rock, "rock")[0].bounds.has_value());
}

TEST(NotedBounds, ScaleWithTheUnitOfTheFile) {
  const std::vector<Vec3> points = sampled_cloud(needle(0.6), {.points = 1500}, 3);
  const VolumeBracket metres = *extract_field_blocks(points, "cloud")[0].bounds;
  FieldScanOptions options;
  options.scan.unit = 0.5;
  const VolumeBracket halves = *extract_field_blocks(points, "cloud", options)[0].bounds;
  EXPECT_NEAR(halves.lower_volume, metres.lower_volume / 8.0, 1e-12);
  EXPECT_NEAR(*halves.upper_volume, *metres.upper_volume / 8.0, 1e-12);
  EXPECT_LT((halves.sides->upper - 0.5 * metres.sides->upper).norm(), 1e-9);
}

TEST(ScannedSurface, HoldsItsTrianglesAndNotWhatSpansAHole) {
  TriangleMesh sheet = geodesic_sphere(10);
  std::erase_if(sheet.triangles,
                [&](const TriangleMesh::Triangle& t) { return sheet.vertices[t[0]].z() > 0.8; });
  const reconstruct_detail::ScannedSurface scanned(sheet);
  const auto& [a, b, c] = sheet.triangles[0];
  EXPECT_TRUE(scanned.contains((sheet.vertices[a] + sheet.vertices[b] + sheet.vertices[c]) / 3.0));
  EXPECT_FALSE(scanned.contains(Vec3(0.0, 0.0, 0.8)));
}

TEST(ScannedSurface, OfPointsHoldsWhatLiesAmongThem) {
  std::vector<Vec3> points = sampled_cloud(geodesic_sphere(20), {.points = 5000}, 3);
  std::erase_if(points, [](const Vec3& p) { return p.z() > 0.9; });
  const reconstruct_detail::ScannedSurface scanned{std::span<const Vec3>(points)};
  EXPECT_TRUE(scanned.contains(Vec3(1.0, 0.0, 0.0)));
  EXPECT_FALSE(scanned.contains(Vec3(0.0, 0.0, 1.0)));
}

TEST(CloudSurface, ReachesIntoTipsThinnerThanThePointsLieApart) {
  const std::vector<Vec3> points = sampled_cloud(needle(), {.points = 8000}, 3);
  double farthest = 0.0;
  for (const Vec3& p : points) farthest = std::max(farthest, p.x());
  const Bounds box = bounds(fit_cloud_surface(points).mesh);
  // The last of them lie on a tip 5 mm thin, 12 mm apart.
  EXPECT_NEAR(box.high.x(), farthest, 0.06);
}

}  // namespace
}  // namespace clast
