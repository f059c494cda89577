#include "shapes/sphero_polyhedron.hpp"

#include <gtest/gtest.h>

#include "core/error.hpp"
#include "mesh/mesh_topology.hpp"
#include "mesh/triangle_tree.hpp"
#include "shapes/convex_hull.hpp"
#include "shapes/coplanar_faces.hpp"
#include "tests/shapes/shape_samples.hpp"

namespace clast {
namespace {

TEST(SpheroPolyhedron, EdgesAreUniqueSortedAndSmallestIndexFirst) {
  const SpheroPolyhedron cube = make_sphero_polyhedron(box_mesh({1, 1, 1}), 0.1);
  EXPECT_EQ(cube.edges.size(), 18u);  // 12 and the six diagonals
  EXPECT_TRUE(std::is_sorted(cube.edges.begin(), cube.edges.end()));
  for (std::size_t i = 0; i < cube.edges.size(); ++i) {
    EXPECT_LT(cube.edges[i][0], cube.edges[i][1]);
    if (i > 0) {
      EXPECT_NE(cube.edges[i], cube.edges[i - 1]);
    }
  }
  EXPECT_EQ(cube.radius, 0.1);
  const TriangleMesh core = core_mesh(cube);
  EXPECT_EQ(core.triangles, box_mesh({1, 1, 1}).triangles);
}

TEST(SpheroPolyhedron, BadRadiusAndEmptyCoreAreRefused) {
  EXPECT_THROW(make_sphero_polyhedron(tetrahedron(), -0.1), InputError);
  EXPECT_THROW(make_sphero_polyhedron(tetrahedron(), std::nan("")), InputError);
  EXPECT_THROW(make_sphero_polyhedron(tetrahedron(), std::numeric_limits<double>::infinity()),
               InputError);
  EXPECT_THROW(make_sphero_polyhedron({}, 0.1), GeometryError);
}

TEST(SpheroPolyhedron, ConcavePolygonsWithCornersInARowAreCutInsideThemselves) {
  SpheroPolyhedron shape;  // an L of area 3 with corners in the middle of its sides
  shape.vertices = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0},   {1, 1, 0},
                    {1, 2, 0}, {0, 2, 0}, {0, 1, 0}, {0, 0.5, 0}, {0, 0.25, 0}};
  shape.faces = {{0, 1, 2, 3, 4, 5, 6, 7, 8, 9}};
  const TriangleMesh cut = core_mesh(shape);
  ASSERT_EQ(cut.triangles.size(), 8u);
  double area = 0.0;
  for (const auto& [a, b, c] : cut.triangles) {
    const Vec3 ab = cut.vertices[b] - cut.vertices[a], ac = cut.vertices[c] - cut.vertices[a];
    EXPECT_GT(ab.cross(ac).z(), 0.0);
    area += 0.5 * ab.cross(ac).z();
  }
  EXPECT_DOUBLE_EQ(area, 3.0);
}

TEST(SpheroPolyhedron, ScalingScalesTheRadiusToo) {
  const SpheroPolyhedron twice = scaled(make_sphero_polyhedron(box_mesh({1, 1, 1}), 0.1), 2.0);
  EXPECT_DOUBLE_EQ(twice.radius, 0.2);
  EXPECT_DOUBLE_EQ(bounds(core_mesh(twice)).diagonal(), 2.0 * std::sqrt(3.0));
  EXPECT_THROW(scaled(twice, 0.0), InputError);
  const SpheroPolyhedron moved = transformed(twice, Pose{Vec3(1, 2, 3), Quat::Identity()});
  EXPECT_EQ(moved.vertices[0], Vec3(twice.vertices[0] + Vec3(1, 2, 3)));
  EXPECT_EQ(moved.radius, twice.radius);
}

TEST(Skin, OfACubeIsClosedAndItsVolumeTendsToTheFormula) {
  const double r = 0.2;
  const double exact = 1.0 + 6.0 * r + 3.0 * kPi * r * r + 4.0 / 3.0 * kPi * r * r * r;
  double error_before = 1.0;
  for (const int segments : {2, 4, 8, 16, 32}) {
    for (const int n : {1, 3}) {
      const TriangleMesh skin =
          rounded_surface_mesh(make_sphero_polyhedron(box_mesh({1, 1, 1}, n), r), segments);
      const MeshReport report = inspect_mesh(skin);
      EXPECT_TRUE(report.is_closed() && report.is_oriented()) << report.summary();
      EXPECT_EQ(report.euler_characteristic, 2);
      EXPECT_EQ(report.degenerate_triangles, 0u);
      const double error = 1.0 - enclosed_volume(skin) / exact;
      EXPECT_GT(error, 0.0);
      if (n == 1) {
        EXPECT_LT(error, 0.3 * error_before);  // second order in the angle step
        error_before = error;
      } else {
        EXPECT_NEAR(error, error_before, 1e-12);  // flat subdivision changes nothing
      }
    }
  }
  EXPECT_LT(error_before, 1e-4);
}

/// Volume of a convex core swept by a ball, after Steiner.
double steiner_volume(const TriangleMesh& hull, double r) {
  const SpheroPolyhedron shape = make_sphero_polyhedron(hull, r);
  double mean_curvature = 0.0;
  for (std::size_t f = 0; f < shape.faces.size(); ++f) {
    for (std::size_t g = f + 1; g < shape.faces.size(); ++g) {
      std::vector<Vec3> shared;
      for (const std::uint32_t v : shape.faces[f]) {
        const auto& other = shape.faces[g];
        if (std::find(other.begin(), other.end(), v) != other.end()) {
          shared.push_back(shape.vertices[v]);
        }
      }
      if (shared.size() != 2) continue;
      const double turn = std::acos(std::min(
          1.0, face_normal(shape, shape.faces[f]).dot(face_normal(shape, shape.faces[g]))));
      mean_curvature += 0.5 * (shared[1] - shared[0]).norm() * turn;
    }
  }
  return enclosed_volume(hull) + surface_area(hull) * r + mean_curvature * r * r +
         4.0 / 3.0 * kPi * r * r * r;
}

TEST(Skin, OfConvexHullsIsASphereWhoseVolumeTendsToSteinersFormula) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const TriangleMesh hull = convex_hull(random_rock(seed, 2, 0.3).vertices);
    const double r = 0.2, exact = steiner_volume(hull, r);
    double error_before = 0.0;
    for (const int segments : {8, 16, 32}) {
      const TriangleMesh skin = rounded_surface_mesh(make_sphero_polyhedron(hull, r), segments);
      EXPECT_TRUE(inspect_mesh(skin).is_closed() && inspect_mesh(skin).is_oriented());
      EXPECT_EQ(inspect_mesh(skin).euler_characteristic, 2);
      const double error = 1.0 - enclosed_volume(skin) / exact;
      EXPECT_GT(error, 0.0);
      const double step = 0.5 * kPi / segments;
      EXPECT_LT(error, step * step * r) << segments;
      EXPECT_TRUE(error_before == 0.0 || error < error_before) << segments;
      error_before = error;
    }
  }
}

TEST(Skin, OfABallAndACapsuleIsClosed) {
  SpheroPolyhedron ball;
  ball.vertices = {{1, 2, 3}};
  ball.radius = 0.5;
  SpheroPolyhedron capsule = ball;
  capsule.vertices.push_back({1, 2, 5});
  capsule.edges = {{0, 1}};
  const double ball_volume = 4.0 / 3.0 * kPi * 0.125, tube = kPi * 0.25 * 2.0;
  const TriangleMesh ball_skin = rounded_surface_mesh(ball, 32),
                     capsule_skin = rounded_surface_mesh(capsule, 32);
  for (const TriangleMesh* skin : {&ball_skin, &capsule_skin}) {
    EXPECT_TRUE(inspect_mesh(*skin).is_closed() && inspect_mesh(*skin).is_oriented());
    EXPECT_EQ(inspect_mesh(*skin).euler_characteristic, 2);
    EXPECT_EQ(inspect_mesh(*skin).degenerate_triangles, 0u);
  }
  const double step = 0.5 * kPi / 32;  // chords of angle h lose shares of order h^2
  EXPECT_NEAR(enclosed_volume(ball_skin) / ball_volume, 1.0, step * step);
  EXPECT_NEAR(enclosed_volume(capsule_skin) / (ball_volume + tube), 1.0, step * step);
}

TEST(Skin, OfANonConvexCoreIsClosed) {
  const TriangleMesh skin = rounded_surface_mesh(make_sphero_polyhedron(l_block(), 0.1));
  EXPECT_TRUE(inspect_mesh(skin).is_closed() && inspect_mesh(skin).is_oriented())
      << inspect_mesh(skin).summary();
}

/// How often the closed surface goes round the point.
int winding_number(const TriangleMesh& mesh, const Vec3& point) {
  double angle = 0.0;  // solid angles by Van Oosterom and Strackee
  for (const auto& [i, j, k] : mesh.triangles) {
    const Vec3 a = mesh.vertices[i] - point, b = mesh.vertices[j] - point,
               c = mesh.vertices[k] - point;
    angle +=
        2.0 * std::atan2(a.dot(b.cross(c)), a.norm() * b.norm() * c.norm() + a.dot(b) * c.norm() +
                                                b.dot(c) * a.norm() + c.dot(a) * b.norm());
  }
  return static_cast<int>(std::lround(angle / (4.0 * kPi)));
}

TEST(Skin, OfANonConvexCoreGoesRoundTheBodyAndNothingElse) {
  std::vector<TriangleMesh> cores = {l_block(), frame()};
  for (std::uint64_t seed = 0; seed < 3; ++seed) cores.push_back(random_rock(seed, 2, 0.2));
  constexpr int kSegments = 4;
  const double sagitta = 1.0 - std::cos(0.25 * kPi / kSegments);  // what chords cut off, times r
  for (const TriangleMesh& core : cores) {
    const double r = 0.05;
    const SpheroPolyhedron shape = make_sphero_polyhedron(core, r);
    const TriangleMesh skin = rounded_surface_mesh(shape, kSegments);
    const TriangleTree tree(core);
    Bounds box = bounds(skin);
    Random random(5);
    int inside = 0, outside = 0;
    for (int i = 0; i < 600; ++i) {
      const Vec3 at(random.uniform(0, 1), random.uniform(0, 1), random.uniform(0, 1));
      const Vec3 point = box.low + at.cwiseProduct(box.high - box.low);
      const double height = tree.signed_distance(point);
      if (height < (1.0 - 3.0 * sagitta) * r) {
        EXPECT_GT(winding_number(skin, point), 0) << height;
        ++inside;
      } else if (height > r) {
        EXPECT_EQ(winding_number(skin, point), 0) << height;
        ++outside;
      }
    }
    EXPECT_GT(inside, 50);
    EXPECT_GT(outside, 50);
  }
}

TEST(Skin, OfPolygonsIsThatOfTheirTriangles) {
  for (const TriangleMesh& core : {box_mesh({1, 1, 1}, 3), l_block()}) {
    const SpheroPolyhedron shape = make_sphero_polyhedron(core, 0.1);
    const TriangleMesh plain = rounded_surface_mesh(shape),
                       merged = rounded_surface_mesh(merge_coplanar_faces(shape));
    EXPECT_TRUE(inspect_mesh(merged).is_closed() && inspect_mesh(merged).is_oriented());
    EXPECT_NEAR(enclosed_volume(merged), enclosed_volume(plain), 1e-12);
    EXPECT_NEAR(surface_area(merged), surface_area(plain), 1e-11);
  }
}

TEST(Skin, WithoutRadiusIsTheCore) {
  const TriangleMesh core = l_block();
  EXPECT_EQ(rounded_surface_mesh(make_sphero_polyhedron(core, 0.0)).triangles, core.triangles);
}

TEST(Skin, OfAnOpenCoreIsRefused) {
  TriangleMesh open = tetrahedron();
  open.triangles.pop_back();
  EXPECT_THROW(rounded_surface_mesh(make_sphero_polyhedron(open, 0.1)), GeometryError);
  EXPECT_THROW(rounded_surface_mesh({}), GeometryError);
  EXPECT_THROW(rounded_surface_mesh(make_sphero_polyhedron(tetrahedron(), 0.1), 0), InputError);
}

class RandomSkins : public testing::TestWithParam<int> {};

TEST_P(RandomSkins, AreClosedWithVerticesAtTheRadiusOfTheirCoreVertex) {
  const TriangleMesh rock = random_rock(GetParam(), 2, 0.2);
  const double r = 0.05;
  const SpheroPolyhedron shape = make_sphero_polyhedron(rock, r);
  const TriangleMesh skin = rounded_surface_mesh(shape, 3);
  const MeshReport report = inspect_mesh(skin);
  EXPECT_TRUE(report.is_closed() && report.is_oriented()) << report.summary();
  EXPECT_EQ(report.euler_characteristic, 2);
  for (const Vec3& point : skin.vertices) {
    double nearest = 1e300;
    for (const Vec3& v : shape.vertices) {
      nearest = std::min(nearest, std::abs((point - v).norm() - r));
    }
    EXPECT_LT(nearest, 1e-14);
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomSkins, testing::Range(0, 20));

}  // namespace
}  // namespace clast
