#include "shapes/detail/covering_height.hpp"

#include <gtest/gtest.h>

#include "mesh/triangle_geometry.hpp"
#include "shapes/detail/deviation_search.hpp"
#include "tests/shapes/shape_samples.hpp"

namespace clast::shapes_detail {
namespace {

std::optional<double> height_over(const TriangleMesh& mesh, const std::array<Vec3, 3>& corners,
                                  double limit = 1.0) {
  const ScanSurface surface(mesh);
  const Vec3 centre = (corners[0] + corners[1] + corners[2]) / 3.0;
  const Vec3 normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]).normalized();
  return CoveringHeight(surface)(corners, normal, surface.tree().closest_point(centre).triangle,
                                 limit);
}

/// A triangle at a height, anticlockwise as seen from above, about a point.
std::array<Vec3, 3> level_triangle(double x, double y, double z, double size) {
  return {Vec3(x - size, y - size, z), Vec3(x + size, y - size, z), Vec3(x, y + size, z)};
}

TEST(CoveringHeight, OverAFaceIsItsDistance) {
  for (const int divisions : {1, 7}) {
    const TriangleMesh cube = box_mesh({2, 2, 2}, divisions);
    const auto over = height_over(cube, level_triangle(1.1, 0.8, 2.25, 0.5));
    ASSERT_TRUE(over);
    EXPECT_NEAR(*over, 0.25, 1e-12);
    EXPECT_TRUE(height_over(cube, level_triangle(1.1, 0.8, 1.75, 0.5)));
  }
}

TEST(CoveringHeight, OverSlopesIsThatOfTheHighestAndLowestPointsInTheTriangle) {
  // The base vertices of the octahedron are far below the triangle, its top is over the centre.
  TriangleMesh octahedron;
  octahedron.vertices = {Vec3(1, 0, 0),  Vec3(0, 1, 0), Vec3(-1, 0, 0),
                         Vec3(0, -1, 0), Vec3(0, 0, 1), Vec3(0, 0, -1)};
  octahedron.triangles = {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4},
                          {1, 0, 5}, {2, 1, 5}, {3, 2, 5}, {0, 3, 5}};
  const double size = 0.1;
  const auto over = height_over(octahedron, level_triangle(0.0, 0.0, 1.0, size), 0.5);
  ASSERT_TRUE(over);
  EXPECT_NEAR(*over, 2.0 * size, 1e-12) << "the slope is 1 along x and y";
  EXPECT_FALSE(height_over(octahedron, level_triangle(0.0, 0.0, 1.0, size), 0.19));
}

TEST(CoveringHeight, BesideTheSurfaceThereIsNone) {
  const TriangleMesh cube = box_mesh({2, 2, 2}, 3);
  EXPECT_FALSE(height_over(cube, level_triangle(1.9, 1.0, 2.1, 0.5))) << "partly beside the cube";
  EXPECT_FALSE(height_over(cube, level_triangle(4.0, 1.0, 2.0, 0.5))) << "beside the cube";
  TriangleMesh open = cube;
  std::erase_if(open.triangles, [&](const TriangleMesh::Triangle& t) {
    const Vec3 centre = (cube.vertices[t[0]] + cube.vertices[t[1]] + cube.vertices[t[2]]) / 3.0;
    return centre.z() > 1.99 && (centre.head<2>() - Vec2(1, 1)).norm() < 0.5;
  });
  EXPECT_FALSE(height_over(open, level_triangle(1.0, 1.0, 2.1, 0.6))) << "a hole in the triangle";
}

TEST(CoveringHeight, IsNeverLessThanTheDistanceOfAnyPoint) {
  Random random(3);
  std::size_t bounded = 0;
  for (const int seed : {1, 2, 3}) {
    const TriangleMesh rock = random_rock(seed, 3, 0.1);
    const ScanSurface surface(rock);
    const CoveringHeight covering(surface);
    for (int trial = 0; trial < 2000; ++trial) {
      const auto t = static_cast<std::uint32_t>(random.uniform_index(rock.triangles.size()));
      const Vec3 centre = surface.tree().first_vertex(t);
      Vec3 normal =
          (surface.tree().face_normal(t) +
           0.2 * Vec3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)))
              .normalized();
      const Vec3 u = normal.unitOrthogonal(), v = normal.cross(u);
      std::array<Vec3, 3> corners;
      const double size = random.uniform(0.01, 0.4), turn = random.uniform(0.0, 6.0);
      for (int k = 0; k < 3; ++k) {
        const double angle = turn + 2.0 * k;
        corners[static_cast<std::size_t>(k)] =
            centre + size * (std::cos(angle) * u + std::sin(angle) * v) + 0.02 * normal;
      }
      const std::optional<double> bound = covering(corners, normal, t, 1.0);
      if (!bound) continue;
      ++bounded;
      for (int i = 0; i <= 4; ++i) {
        for (int j = 0; j <= 4 - i; ++j) {
          const Vec3 point = 0.25 * (i * corners[0] + j * corners[1] + (4 - i - j) * corners[2]);
          EXPECT_LE(std::sqrt(surface.tree().closest_point(point).squared_distance),
                    *bound + 1e-12);
        }
      }
    }
  }
  EXPECT_GT(bounded, 2000u);
}

}  // namespace
}  // namespace clast::shapes_detail
