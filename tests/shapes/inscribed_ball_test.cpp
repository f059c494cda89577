#include "shapes/inscribed_ball.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/error.hpp"
#include "mesh/isotropic_remeshing.hpp"
#include "mesh/mesh_topology.hpp"
#include "tests/shapes/shape_samples.hpp"

namespace clast {
namespace {

const Pose kBallMotion{Vec3(20.0, -4.0, 7.0), Quat(0.5, -0.3, 0.7, 0.2).normalized()};

TEST(InscribedBall, OfACuboidIsHalfItsSmallestSide) {
  const Ball ball = largest_inscribed_ball(transformed(box_mesh(Vec3(3, 2, 1)), kBallMotion));
  EXPECT_LE(ball.radius, 0.5 + 1e-12);
  EXPECT_GE(ball.radius, 0.5 / 1.01);
}

// Edge a: a sqrt 6 / 12 from the faces, at the centroid.
TEST(InscribedBall, OfARegularTetrahedron) {
  TriangleMesh mesh;
  mesh.vertices = {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
  mesh.triangles = {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}};
  const Ball ball = largest_inscribed_ball(transformed(mesh, kBallMotion), 1e-5);
  EXPECT_NEAR(ball.radius, 1.0 / std::sqrt(3.0), 1e-5);
  EXPECT_LT((ball.centre - kBallMotion.translation).norm(), 1e-3);
}

TEST(InscribedBall, WithNothingInsideIsRefused) {
  EXPECT_THROW(largest_inscribed_ball(TriangleMesh{}), GeometryError);
  TriangleMesh inward = box_mesh(Vec3(1, 1, 1));
  for (auto& t : inward.triangles) std::swap(t[0], t[1]);
  EXPECT_THROW(largest_inscribed_ball(inward), GeometryError);
}

TEST(Remeshing, KeepsTheSurfaceInEvenTriangles) {
  const TriangleMesh mesh = remesh_isotropic(box_mesh(Vec3(3, 2, 1)), 0.1);
  const MeshReport report = inspect_mesh(mesh);
  EXPECT_TRUE(report.is_closed() && report.is_oriented());
  EXPECT_EQ(report.euler_characteristic, 2);
  EXPECT_NEAR(enclosed_volume(mesh), 6.0, 0.06);
  double sum = 0.0;
  int long_edges = 0;
  for (const auto& t : mesh.triangles) {
    for (int i = 0; i < 3; ++i) {
      const double length = (mesh.vertices[t[i]] - mesh.vertices[t[(i + 1) % 3]]).norm();
      sum += length;
      long_edges += length > 0.2;
    }
  }
  EXPECT_NEAR(sum / (3.0 * static_cast<double>(mesh.triangles.size())), 0.1, 0.015);
  EXPECT_EQ(long_edges, 0);
  const TriangleMesh again = remesh_isotropic(box_mesh(Vec3(3, 2, 1)), 0.1);
  EXPECT_TRUE(again.vertices == mesh.vertices && again.triangles == mesh.triangles);
}

TEST(Remeshing, OfOpenSurfacesOrToNoLengthIsRefused) {
  TriangleMesh open = box_mesh(Vec3(1, 1, 1));
  open.triangles.pop_back();
  EXPECT_THROW(remesh_isotropic(open, 0.1), GeometryError);
  for (const double bad : {0.0, -0.1, std::nan(""), 1e-6}) {
    EXPECT_THROW(remesh_isotropic(box_mesh(Vec3(1, 1, 1)), bad), InputError) << bad;
  }
}

}  // namespace
}  // namespace clast
