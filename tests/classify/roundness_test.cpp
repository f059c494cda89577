#include "classify/roundness.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/error.hpp"
#include "mesh/isotropic_remeshing.hpp"
#include "shapes/inscribed_ball.hpp"
#include "shapes/sphero_polyhedron.hpp"
#include "tests/shapes/shape_samples.hpp"

namespace clast {
namespace {

/// An ellipsoid with these half axes in even triangles.
TriangleMesh ellipsoid(const Vec3& half_axes, double edge_length) {
  TriangleMesh mesh = random_rock(1, 5, 0.0);
  for (Vec3& v : mesh.vertices) v = v.normalized().cwiseProduct(half_axes);
  return remesh_isotropic(mesh, edge_length);
}

// Half axes b, b, a: with w^2 = a^2 cos^2 t + b^2 sin^2 t at the latitude t the larger curvature is
// a/(b w), everywhere above that of the inscribed ball of radius b, and the area 2 pi b w cos t dt.
TEST(Roundness, OfAProlateEllipsoidIsTheMeanRadiusOfCurvature) {
  const double a = 1.6, b = 1.0;
  double area = 0.0, weighted = 0.0;
  for (int i = 0; i < 10000; ++i) {
    const double t = kPi * ((i + 0.5) / 10000.0 - 0.5);
    const double w = std::hypot(a * std::cos(t), b * std::sin(t));
    area += w * std::cos(t);
    weighted += w * std::cos(t) * w / a;
  }
  const Roundness found = roundness(ellipsoid({b, b, a}, 0.12));
  EXPECT_NEAR(found.value, weighted / area, 0.05 * weighted / area);
  EXPECT_NEAR(found.inscribed_radius, b, 0.01 * b);
  EXPECT_NEAR(found.edge_length, 0.12, 0.02);
  EXPECT_GT(found.corner_fraction, 0.7);
}

TEST(Roundness, OfASphereIsNearlyOne) {
  EXPECT_GT(roundness(ellipsoid({1, 1, 1}, 0.15)).value, 0.9);
}

// The corners of a rounded cube of side 1 have the radius r everywhere: r/(1/2), to an edge length
// of the mesh.
TEST(Roundness, OfARoundedCubeIsTheRadiusOfItsEdgesToAnEdgeLength) {
  constexpr double kEdge = 0.05;
  for (const double r : {0.1, 0.25, 0.45}) {
    const SpheroPolyhedron cube =
        make_sphero_polyhedron(box_mesh(Vec3::Constant(1.0 - 2.0 * r)), r);
    const TriangleMesh skin = remesh_isotropic(rounded_surface_mesh(cube, 24), kEdge);
    const double value = roundness(skin).value;
    EXPECT_NEAR(0.5 * value, r, 1.2 * kEdge);
    const TriangleMesh elsewhere = scaled(
        transformed(skin, Pose{Vec3(3, -2, 5), Quat(0.5, -0.3, 0.7, 0.2).normalized()}), 3.0);
    EXPECT_NEAR(roundness(elsewhere).value, value, 0.02 * value);
  }
}

TEST(Roundness, OfAnOpenSurfaceIsRefused) {
  TriangleMesh open = box_mesh(Vec3(1, 1, 1));
  open.triangles.pop_back();
  EXPECT_THROW(roundness(open), GeometryError);
}

}  // namespace
}  // namespace clast
