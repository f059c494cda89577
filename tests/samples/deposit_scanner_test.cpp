#include "samples/deposit/deposit_scanner.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "mesh/triangle_tree.hpp"
#include "samples/deposit/point_grid.hpp"
#include "tests/support/test_bodies.hpp"

namespace clast {
namespace {

/// A box 1 m wide and 0.5 m high on a floor 4 m wide.
DepositScene box_on_floor() {
  DepositScene scene;
  scene.mesh = plane_mesh(2.0, 100);
  scene.block_of_triangle.assign(scene.mesh.triangles.size(), 0);
  TriangleMesh body = core_mesh(box(1.0, {1.0, 1.0, 0.5}, 0.0, 20).shape);
  for (Vec3& vertex : body.vertices) vertex.z() += 0.25;
  scene.mesh = merged(std::move(scene.mesh), body);
  scene.block_of_triangle.resize(scene.mesh.triangles.size(), 1);
  return scene;
}

/// Rays through all triangles of a mesh, one by one.
RayHit first_hit(const TriangleMesh& mesh, const Vec3& origin, const Vec3& direction) {
  RayHit hit;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const Vec3& a = mesh.vertices[mesh.triangles[t][0]];
    const Vec3 u = mesh.vertices[mesh.triangles[t][1]] - a;
    const Vec3 v = mesh.vertices[mesh.triangles[t][2]] - a;
    const double determinant = u.dot(direction.cross(v));
    if (determinant <= 0.0) continue;
    const Vec3 w = origin - a;
    const double first = w.dot(direction.cross(v)) / determinant;
    const double second = direction.dot(w.cross(u)) / determinant;
    const double distance = v.dot(w.cross(u)) / determinant;
    if (distance < 0.0 || first < 0.0 || second < 0.0 || first + second > 1.0) continue;
    if (hit.triangle == kNoIndex || distance < hit.distance) hit = {t, distance};
  }
  return hit;
}

void expect_first_hits(const DepositRecipe& recipe) {
  const DepositScene scene = box_on_floor();
  const ScanView view = plan_views(recipe, scene).back();
  Random random(1);
  const std::vector<Vec3> directions = draw_ray_directions(view, random);
  const std::vector<RayHit> hits = cast_rays(view, directions, scene.mesh);
  int compared = 0;
  for (int i = 0; i < 1500; ++i) {
    const std::size_t ray = random.uniform_index(directions.size());
    const RayHit& hit = hits[ray];
    const RayHit expected = first_hit(scene.mesh, view.station, directions[ray]);
    EXPECT_EQ(hit.triangle == kNoIndex, expected.triangle == kNoIndex);
    if (hit.triangle == kNoIndex) continue;
    EXPECT_NEAR(hit.distance, expected.distance, 1e-9);
    ++compared;
  }
  EXPECT_GT(compared, 20);
}

TEST(DepositScanner, RaysOfAPictureHitTheFirstTriangle) {
  expect_first_hits({.spacings_per_block = 5.0});
}

TEST(DepositScanner, RaysOfAPanoramaHitTheFirstTriangle) {
  expect_first_hits({.spacings_per_block = 5.0, .stations = ScanStations::kTripod});
}

TEST(DepositScanner, PointsLieOnTheSurfacesThatAreSeenAtTheSpacing) {
  const DepositScene scene = box_on_floor();
  const DepositRecipe recipe{.spacings_per_block = 10.0, .noise = 0.0};
  const DepositScan scan = scan_deposit(recipe, scene, 1);
  const TriangleTree tree(scene.mesh);
  std::map<std::uint32_t, int> counts;
  for (const ScannedPoint& point : scan.points) {
    EXPECT_LT(std::sqrt(tree.closest_point(point.position.cast<double>()).squared_distance), 1e-6);
    EXPECT_GT(point.position.z(), -1e-6f);
    ++counts[scene.block_of_triangle[point.triangle]];
  }
  const double per_area = 1.0 / (recipe.spacing() * recipe.spacing());
  EXPECT_NEAR(counts[1], (1.0 + 4.0 * 0.5) * per_area, 0.15 * 3.0 * per_area);
  EXPECT_NEAR(counts[0], (16.0 - 1.0) * per_area, 0.06 * 15.0 * per_area);
}

TEST(DepositScanner, NoiseIsAlongTheRayAndAsLargeAsAsked) {
  DepositScene scene;
  scene.mesh = plane_mesh(2.0, 10);
  scene.block_of_triangle.assign(scene.mesh.triangles.size(), 0);
  const DepositRecipe recipe{.spacings_per_block = 10.0, .noise = 0.4};
  const DepositScan scan = scan_deposit(recipe, scene, 1);
  double squares = 0.0;
  for (const ScannedPoint& point : scan.points) {
    squares += std::pow(static_cast<double>(point.position.z()), 2);
  }
  const double deviation = std::sqrt(squares / static_cast<double>(scan.points.size()));
  // Heights of oblique rays have less of it: between the cosine of 60 degrees and 1.
  EXPECT_GT(deviation, 0.5 * 0.4 * recipe.spacing());
  EXPECT_LT(deviation, 1.03 * 0.4 * recipe.spacing());
}

TEST(PointGrid, FindsThePointsThatASearchOfAllFinds) {
  Random random(3);
  PointGrid grid(0.1);
  std::vector<Vec3> points;
  const auto draw = [&] {
    return Vec3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
  };
  for (int i = 0; i < 3000; ++i) {
    points.push_back(draw());
    grid.add(points.back());
  }
  for (int i = 0; i < 200; ++i) {
    const Vec3 place = draw();
    std::size_t found = 0, expected = 0;
    grid.any_within(place, 0.1, [&](std::uint32_t) {
      ++found;
      return false;
    });
    for (const Vec3& point : points) expected += (point - place).norm() <= 0.1 ? 1 : 0;
    EXPECT_EQ(found, expected);
    EXPECT_EQ(grid.has_point_within(place, 0.1), expected > 0);
  }
}

}  // namespace
}  // namespace clast
