#include "shapes/convex_hull.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "mesh/mesh_topology.hpp"
#include "tests/shapes/shape_samples.hpp"

namespace clast {
namespace {

std::vector<Vec3> shuffled(std::vector<Vec3> points, std::uint64_t seed) {
  Random random(seed);
  for (std::size_t i = points.size(); i > 1; --i) {
    std::swap(points[i - 1], points[random.uniform_index(i)]);
  }
  return points;
}

TEST(ConvexHull, HoldsEveryPointAndOnlyExtremeOnes) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    Random random(seed);
    std::vector<Vec3> points;
    for (int i = 0; i < 200; ++i) {
      points.emplace_back(random.normal(), random.normal(), random.normal());
    }
    const TriangleMesh hull = convex_hull(points);
    const MeshReport report = inspect_mesh(hull);
    EXPECT_TRUE(report.is_closed() && report.is_oriented());
    EXPECT_EQ(report.euler_characteristic, 2);
    EXPECT_GT(enclosed_volume(hull), 0.0);
    for (const auto& [a, b, c] : hull.triangles) {
      const Vec3 normal = (hull.vertices[b] - hull.vertices[a])
                              .cross(hull.vertices[c] - hull.vertices[a])
                              .normalized();
      for (const Vec3& p : points) EXPECT_LT(normal.dot(p - hull.vertices[a]), 1e-12);
    }
    for (const Vec3& v : hull.vertices) EXPECT_EQ(std::count(points.begin(), points.end(), v), 1);
  }
}

TEST(ConvexHull, PointsOnFacesAndEdgesAreDropped) {
  const TriangleMesh hull = convex_hull(box_mesh(Vec3(1, 2, 3), 4).vertices);
  EXPECT_EQ(hull.vertices.size(), 8u);
  EXPECT_EQ(hull.triangles.size(), 12u);
  EXPECT_NEAR(enclosed_volume(hull), 6.0, 1e-14);
}

// CGAL cuts flat faces into triangles by places in memory, which follow from what was done before.
TEST(ConvexHull, FlatFacesAreCutTheSameWhateverWasDoneBefore) {
  std::vector<Vec3> prism;
  for (int i = 0; i < 200; ++i) {
    const double angle = 2.0 * kPi * i / 200.0;
    for (const double z : {0.0, 1.0}) prism.emplace_back(std::cos(angle), std::sin(angle), z);
  }
  const TriangleMesh hull = convex_hull(prism);
  EXPECT_EQ(hull.vertices.size(), 400u);
  EXPECT_EQ(hull.triangles.size(), 796u);
  EXPECT_TRUE(inspect_mesh(hull).is_closed());
  std::vector<std::vector<char>> kept;
  Random random(3);
  for (int i = 0; i < 10; ++i) {
    for (int k = 0; k < 200; ++k) {
      kept.emplace_back(random.uniform_index(20000));
      if (random.uniform_index(2) == 0) kept[random.uniform_index(kept.size())] = {};
    }
    const TriangleMesh again = convex_hull(prism);
    EXPECT_EQ(hull.vertices, again.vertices) << i;
    EXPECT_EQ(hull.triangles, again.triangles) << i;
  }
}

TEST(ConvexHull, SameBitsForAnyOrder) {
  const std::vector<Vec3> points = box_mesh(Vec3(1, 2, 3), 3).vertices;
  const TriangleMesh hull = convex_hull(points);
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const TriangleMesh other = convex_hull(shuffled(points, seed));
    EXPECT_EQ(hull.vertices, other.vertices);
    EXPECT_EQ(hull.triangles, other.triangles);
  }
}

TEST(ConvexHull, WhatEnclosesNoVolumeIsRefused) {
  std::vector<Vec3> points;
  EXPECT_THROW(convex_hull(points), GeometryError);
  points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  EXPECT_THROW(convex_hull(points), GeometryError);
  points.push_back({1, 1, 1e-15});
  EXPECT_THROW(convex_hull(points), GeometryError);
  points = {{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}, {4, 4, 4}};
  EXPECT_THROW(convex_hull(points), GeometryError);
  points.assign(7, Vec3(1, 2, 3));
  EXPECT_THROW(convex_hull(points), GeometryError);
  points = tetrahedron().vertices;
  points.push_back({0, 0, std::nan("")});
  EXPECT_THROW(convex_hull(points), GeometryError);
}

TEST(AffineSpan, CountsTheDimensionsThatPointsFill) {
  EXPECT_EQ(affine_span({}).dimension, 0);
  const Vec3 at(5e6, -3, 2), u = Vec3(1, 2, 3).normalized(), v = u.unitOrthogonal();
  std::vector<Vec3> points = {at, at};
  EXPECT_EQ(affine_span(points).dimension, 0);
  points.push_back(Vec3(1, 2, 3));
  EXPECT_EQ(affine_span(points).dimension, 1);
  points = {Vec3::Zero(), u, 2 * u, v, u - 3 * v};
  EXPECT_EQ(affine_span(points).dimension, 2);
  EXPECT_NEAR(std::abs(affine_span(points).axes.col(2).dot(u.cross(v))), 1.0, 1e-14);
  points.push_back(u.cross(v));
  EXPECT_EQ(affine_span(points).dimension, 3);
}

}  // namespace
}  // namespace clast
