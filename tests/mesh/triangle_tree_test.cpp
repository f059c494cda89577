#include "mesh/triangle_tree.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <vector>

#include "mesh/triangle_geometry.hpp"
#include "tests/support/rock_mesh.hpp"

namespace clast {
namespace {

TriangleMesh rock(int seed, const Vec3& centre = Vec3::Zero()) {
  TriangleMesh mesh = rough_rock_mesh(8, {1.0, 0.8, 0.6}, static_cast<std::uint64_t>(seed), 0.1);
  for (Vec3& vertex : mesh.vertices) vertex += centre;
  return mesh;
}

/// Points near and far, and the vertices and side middles, which several triangles have in common.
std::vector<Vec3> query_points(const TriangleMesh& mesh, const Vec3& centre) {
  std::vector<Vec3> points = mesh.vertices;
  for (const auto& [a, b, c] : mesh.triangles) {
    points.push_back(0.5 * (mesh.vertices[a] + mesh.vertices[b]));
  }
  Random random(5);
  for (int i = 0; i < 300; ++i) {
    const double reach = i % 3 == 0 ? 20.0 : 3.0;
    points.push_back(centre + reach * Vec3(random.uniform() - 0.5, random.uniform() - 0.5,
                                           random.uniform() - 0.5));
  }
  return points;
}

class TriangleTrees : public testing::TestWithParam<double> {};

TEST_P(TriangleTrees, FindTheNearestTriangleOfLowestIndexWithAnyHint) {
  const Vec3 centre = GetParam() * Vec3(1.0, -2.0, 0.3);
  const TriangleMesh mesh = rock(3, centre);
  const TriangleTree tree(mesh);
  const auto count = static_cast<std::uint32_t>(mesh.triangles.size());
  for (const Vec3& point : query_points(mesh, centre)) {
    double least = std::numeric_limits<double>::infinity();
    for (std::uint32_t t = 0; t < count; ++t) least = std::min(least, tree.distance_to(t, point));
    const TriangleTree::Closest found = tree.closest_point(point);
    EXPECT_NEAR(std::sqrt(found.squared_distance), least, 1e-12 * (1.0 + centre.norm()));
    for (const std::uint32_t hint : {count / 3, count - 1, found.triangle}) {
      const TriangleTree::Closest again = tree.closest_point(point, hint);
      EXPECT_EQ(again.triangle, found.triangle);
      EXPECT_EQ(again.point, found.point);
      EXPECT_EQ(again.feature, found.feature);
    }
    for (std::uint32_t t = 0; t < found.triangle; ++t) {
      EXPECT_GE(tree.distance_to(t, point), std::sqrt(found.squared_distance));
    }
  }
}

Vec3 random_direction(Random& random) {
  return Vec3(random.uniform() - 0.5, random.uniform() - 0.5, random.uniform() - 0.5).normalized();
}

TEST_P(TriangleTrees, MissNoPointAboveAPlaneInABall) {
  const TriangleMesh mesh = rock(4, GetParam() * Vec3(1.0, -2.0, 0.3));
  const TriangleTree tree(mesh);
  Random random(8);
  int above = 0, none = 0;
  for (int i = 0; i < 2000; ++i) {
    const TriangleMesh::Triangle& t = mesh.triangles[random.uniform_index(mesh.triangles.size())];
    const double a = random.uniform(), b = (1.0 - a) * random.uniform();
    const Vec3 point =
        a * mesh.vertices[t[0]] + b * mesh.vertices[t[1]] + (1.0 - a - b) * mesh.vertices[t[2]];
    const Vec3 normal = random_direction(random);
    const double radius = random.uniform(0.01, 0.3), away = random.uniform(0.0, 2.0) * radius;
    const Vec3 centre = point + away * random_direction(random);
    const double height = normal.dot(point) - 1e-6;
    const bool found = tree.has_point_above(normal, height, centre, radius);
    if (away < 0.999 * radius) {
      EXPECT_TRUE(found);
      ++above;
    } else if (!found) {
      ++none;
    }
  }
  EXPECT_GT(above, 500);
  EXPECT_GT(none, 100) << "a tree that always says yes would pass";
}

TEST_P(TriangleTrees, FindVerticesAbovePlanes) {
  const Vec3 centre = GetParam() * Vec3(1.0, -2.0, 0.3);
  const TriangleMesh mesh = rock(4, centre);
  const TriangleTree tree(mesh);
  Random random(7);
  for (int i = 0; i < 200; ++i) {
    const Vec3 normal = random_direction(random);
    double highest = -std::numeric_limits<double>::infinity();
    for (const Vec3& vertex : mesh.vertices) highest = std::max(highest, normal.dot(vertex));
    const double margin = 1e-3;
    EXPECT_TRUE(tree.has_point_above(normal, highest - margin, centre, 10.0));
    EXPECT_FALSE(tree.has_point_above(normal, highest + margin, centre, 10.0));
    EXPECT_FALSE(tree.has_point_above(normal, highest - margin, centre - 30.0 * normal, 10.0));
  }
}

TEST_P(TriangleTrees, RaysLeaveThroughTheFirstOutwardTriangle) {
  const Vec3 centre = GetParam() * Vec3(1.0, -2.0, 0.3);
  const TriangleMesh mesh = rock(5, centre);
  const TriangleTree tree(mesh);
  Random random(9);
  for (int i = 0; i < 200; ++i) {
    const Vec3 direction = random_direction(random);
    const auto hit = tree.first_exit(centre, direction, 0xffffffffu);
    ASSERT_TRUE(hit.has_value());
    const Vec3 exit = centre + hit->distance * direction;
    EXPECT_NEAR(tree.signed_distance(exit), 0.0, 1e-9 * (1.0 + centre.norm()));
    EXPECT_LT(tree.signed_distance(centre + 0.999 * hit->distance * direction), 0.0);
    EXPECT_GT(unit_normal(mesh, mesh.triangles[hit->triangle]).dot(direction), 0.0);
  }
}

INSTANTIATE_TEST_SUITE_P(Offsets, TriangleTrees, testing::Values(0.0, 300.0, 4e5));

TEST(TriangleTree, OfFewTriangles) {
  TriangleMesh mesh;
  mesh.vertices = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(1, 1, 0), Vec3(2, 1, 0)};
  for (const TriangleMesh::Triangle& t : {TriangleMesh::Triangle{0, 1, 2}, {1, 3, 2}, {1, 4, 3}}) {
    mesh.triangles.push_back(t);
    const TriangleTree tree(mesh);
    const Vec3 inside = (mesh.vertices[t[0]] + mesh.vertices[t[1]] + mesh.vertices[t[2]]) / 3.0;
    const TriangleTree::Closest found = tree.closest_point(inside + Vec3(0, 0, 0.25));
    EXPECT_EQ(found.triangle, mesh.triangles.size() - 1);
    EXPECT_DOUBLE_EQ(found.squared_distance, 0.0625);
    EXPECT_EQ(tree.outward_normal(found.triangle, found.feature), Vec3::UnitZ());
  }
}

}  // namespace
}  // namespace clast
