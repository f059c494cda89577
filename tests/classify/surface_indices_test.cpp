#include "classify/surface_indices.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>

#include "core/error.hpp"
#include "core/random.hpp"
#include "massprops/sphero.hpp"
#include "shapes/convex_hull.hpp"
#include "tests/shapes/shape_samples.hpp"

namespace clast {
namespace {

const Pose kMotion{Vec3(3, -2, 5), Quat(0.5, -0.3, 0.7, 0.2).normalized()};

SpheroPolyhedron gridded_cuboid(const Vec3& sides, double radius, int cells = 1) {
  return transformed(make_sphero_polyhedron(box_mesh(sides, cells), radius), kMotion);
}

SpheroPolyhedron ball(double radius) {
  SpheroPolyhedron body;
  body.vertices = {Vec3(1, 2, 3)};
  body.radius = radius;
  return body;
}

TEST(TrueSphericity, OfSphereCubeAndTetrahedron) {
  for (const double r : {0.3, 2.0}) {
    EXPECT_NEAR(true_sphericity(4.0 / 3.0 * kPi * r * r * r, 4.0 * kPi * r * r), 1.0, 1e-15);
  }
  EXPECT_NEAR(true_sphericity(1.0, 6.0), std::cbrt(kPi / 6.0), 1e-15);
  // Edge 1: V = 1/(6 sqrt 2), A = sqrt 3.
  EXPECT_NEAR(true_sphericity(1.0 / (6.0 * std::sqrt(2.0)), std::sqrt(3.0)),
              std::cbrt(kPi / (6.0 * std::sqrt(3.0))), 1e-15);
}

// The L of three unit squares fills 3 of 3.5 of its hull: the corner cut is a half square.
TEST(Convexity, OfAnLBlock) {
  TriangleMesh mesh;
  const std::vector<Vec2> outline = {{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
  for (const double z : {0.0, 1.0}) {
    for (const Vec2& p : outline) mesh.vertices.emplace_back(p.x(), p.y(), z);
  }
  for (const auto& [a, b, c] : {std::array{0u, 1u, 2u}, std::array{0u, 2u, 3u},
                                std::array{0u, 3u, 4u}, std::array{0u, 4u, 5u}}) {
    mesh.triangles.push_back({a, c, b});
    mesh.triangles.push_back({a + 6, b + 6, c + 6});
  }
  for (std::uint32_t i = 0; i < 6; ++i) {
    const std::uint32_t j = (i + 1) % 6;
    mesh.triangles.push_back({i, j, j + 6});
    mesh.triangles.push_back({i, j + 6, i + 6});
  }
  const SpheroPolyhedron sharp = make_sphero_polyhedron(mesh, 0.0);
  EXPECT_NEAR(convexity(sharp, 3.0), 6.0 / 7.0, 1e-12);
  // Faces by their directions: x 4, y 4, z 6 of 14.
  const Vec3 f = orientation_tensor(sharp).eigenvalues;
  EXPECT_TRUE(f.isApprox(Vec3(6, 4, 4) / 14.0, 1e-12));
  // With a radius the strips of width r at the reflex edge are lost, and each convex edge adds a
  // quarter of a cylinder. Of the five upright ones three lie along x = y and two across it, which
  // leaves one to couple x and y by r/2.
  const double r = 0.1;
  const double side = 4.0 - r + 0.25 * kPi * r * (8.0 + 5.0) + 4.0 / 3.0 * kPi * r * r;
  const double top = 6.0 + 0.25 * kPi * r * 16.0 + 4.0 / 3.0 * kPi * r * r;
  const Vec3 expected = Vec3(top, side + 0.5 * r, side - 0.5 * r) / (top + 2.0 * side);
  const Vec3 g = orientation_tensor(make_sphero_polyhedron(mesh, r)).eigenvalues;
  EXPECT_TRUE(g.isApprox(expected, 1e-12)) << g.transpose() << "; " << expected.transpose();
}

TEST(Convexity, OfAConvexBodyIsOne) {
  const SpheroPolyhedron body = gridded_cuboid(Vec3(3, 2, 1), 0.2);
  EXPECT_NEAR(convexity(body, convex_sphero_mass_properties(body, 1.0).volume), 1.0, 1e-12);
}

// Many vertices on flat walls, off them by rounding: edges of the hull are reflex by a hair, and
// some of its triangles are slivers.
TEST(Convexity, OfAColumnWithPointsOnItsWallsIsOne) {
  Random random(7);
  for (int digits = 7; digits <= 16; ++digits) {
    const double off = std::pow(10.0, -digits);
    for (int trial = 0; trial < 5; ++trial) {
      std::vector<Vec3> places;
      for (int k = 0; k < 6; ++k) {
        for (int level = 0; level < 8; ++level) {
          const double angle = 0.3 + k * kPi / 3.0;
          places.push_back(Vec3(0.3 * std::cos(angle), 0.3 * std::sin(angle), 0.2 * level) +
                           off * random.unit_vector());
        }
      }
      const SpheroPolyhedron column = make_sphero_polyhedron(convex_hull(places), 0.005);
      // A hexagon of side 0.3, rounded: V + A r + M r^2 + 4 pi r^3 / 3.
      const double hexagon = 1.5 * std::sqrt(3.0) * 0.09, height = 1.4, r = 0.005;
      const double mean_curvature = kPi / 2.0 * 12.0 * 0.3 / 2.0 + kPi / 3.0 * 6.0 * height / 2.0;
      const double volume = hexagon * height + (2.0 * hexagon + 1.8 * height) * r +
                            mean_curvature * r * r + 4.0 / 3.0 * kPi * r * r * r;
      EXPECT_NEAR(convexity(column, volume), 1.0, 1e-4) << "off by " << off;
    }
  }
}

TEST(OrientationTensor, OfABallIsTheSameAllAround) {
  const OrientationTensor o = orientation_tensor(ball(0.7));
  EXPECT_NEAR(o.compactness(), 1.0, 1e-15);
  EXPECT_NEAR(o.flakiness(), 0.0, 1e-15);
  EXPECT_NEAR(o.rodness(), 0.0, 1e-15);
}

// Faces of a x b x c: n n^T weighs b c, a c and a b.
TEST(OrientationTensor, OfACuboidWeighsItsFaces) {
  for (const int cells : {1, 3}) {
    const OrientationTensor o = orientation_tensor(gridded_cuboid(Vec3(3, 2, 1), 0.0, cells));
    EXPECT_TRUE(o.eigenvalues.isApprox(Vec3(6, 3, 2) / 11.0, 1e-12));
    EXPECT_NEAR(o.compactness(), 1.0 / 3.0, 1e-12);
    EXPECT_NEAR(o.flakiness(), 0.5, 1e-12);
    EXPECT_NEAR(o.rodness(), 1.0 / 6.0, 1e-12);
  }
}

// Along x: two faces, the quarter cylinders of the 8 edges across x, each with half of its area
// (pi r/2 per length) on x, and a third of the sphere.
TEST(OrientationTensor, OfARoundedCuboidInClosedForm) {
  const double a = 3, b = 2, c = 1, r = 0.3;
  const double sphere = 4.0 / 3.0 * kPi * r * r;
  const double x = 2 * b * c + kPi * r * (b + c) + sphere;
  const double y = 2 * a * c + kPi * r * (a + c) + sphere;
  const double z = 2 * a * b + kPi * r * (a + b) + sphere;
  const Vec3 f = orientation_tensor(gridded_cuboid(Vec3(a, b, c), r)).eigenvalues;
  EXPECT_TRUE(f.isApprox(Vec3(z, y, x) / (x + y + z), 1e-12));
}

// Second method: the triangles of a fine skin.
TEST(OrientationTensor, AgreesWithAFineSkin) {
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    Random random(seed);
    std::vector<Vec3> points;
    for (int i = 0; i < 20; ++i) {
      points.push_back(random.unit_vector().cwiseProduct(Vec3(1.0, 0.6, 0.4)));
    }
    const SpheroPolyhedron body = make_sphero_polyhedron(convex_hull(points), 0.15);
    const TriangleMesh skin = rounded_surface_mesh(body, 24);
    Mat3 sum = Mat3::Zero();
    for (const auto& [a, b, c] : skin.triangles) {
      const Vec3 n =
          0.5 * (skin.vertices[b] - skin.vertices[a]).cross(skin.vertices[c] - skin.vertices[a]);
      if (n.norm() > 0.0) sum += n * n.transpose() / n.norm();
    }
    const Eigen::SelfAdjointEigenSolver<Mat3> eigen(sum / sum.trace());
    EXPECT_TRUE(
        orientation_tensor(body).eigenvalues.isApprox(Vec3(eigen.eigenvalues().reverse()), 2e-3));
  }
}

TEST(OrientationTensor, OfAnOpenCoreIsRefused) {
  TriangleMesh open = box_mesh(Vec3(1, 1, 1));
  open.triangles.pop_back();
  EXPECT_THROW(orientation_tensor(make_sphero_polyhedron(open, 0.1)), GeometryError);
}

}  // namespace
}  // namespace clast
