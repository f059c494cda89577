#include "shapes/coplanar_faces.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "mesh/mesh_topology.hpp"
#include "shapes/edge_convexity.hpp"
#include "tests/shapes/shape_samples.hpp"

namespace clast {
namespace {

struct Counts {
  std::size_t vertices, edges, faces;
  bool operator==(const Counts&) const = default;
};

Counts counts(const SpheroPolyhedron& shape) {
  return {shape.vertices.size(), shape.edges.size(), shape.faces.size()};
}

/// How many edges are flat, convex and reflex.
std::array<std::ptrdiff_t, 3> bends(const SpheroPolyhedron& shape) {
  const std::vector<EdgeConvexity> all = edge_convexities(shape);
  return {std::count(all.begin(), all.end(), EdgeConvexity::kFlat),
          std::count(all.begin(), all.end(), EdgeConvexity::kConvex),
          std::count(all.begin(), all.end(), EdgeConvexity::kReflex)};
}

std::ostream& operator<<(std::ostream& out, const Counts& c) {
  return out << c.vertices << " vertices, " << c.edges << " edges, " << c.faces << " faces";
}

void expect_same_solid(const SpheroPolyhedron& merged, const TriangleMesh& mesh) {
  const TriangleMesh core = core_mesh(merged);
  const MeshReport report = inspect_mesh(core);
  EXPECT_TRUE(report.is_closed() && report.is_oriented()) << report.summary();
  EXPECT_EQ(report.degenerate_triangles, 0u);
  EXPECT_EQ(report.euler_characteristic, inspect_mesh(mesh).euler_characteristic);
  EXPECT_NEAR(enclosed_volume(core), enclosed_volume(mesh), 1e-11 * enclosed_volume(mesh));
  EXPECT_NEAR(surface_area(core), surface_area(mesh), 1e-11 * surface_area(mesh));
}

TEST(CoplanarFaces, OfABoxBecomeSixHoweverItIsMeshedAndTurned) {
  Random random(3);
  const Pose somewhere{{10, -20, 5}, random.rotation()};
  for (const int n : {1, 2, 5}) {
    const TriangleMesh box = box_mesh({1, 2, 3}, n);
    for (const TriangleMesh& mesh : {box, transformed(box, somewhere)}) {
      const SpheroPolyhedron shape = make_sphero_polyhedron(mesh, 0.1);
      const SpheroPolyhedron merged = merge_coplanar_faces(shape);
      EXPECT_EQ(counts(merged), (Counts{8, 12, 6}));
      EXPECT_EQ(merged.radius, 0.1);
      EXPECT_EQ(bends(merged), (std::array<std::ptrdiff_t, 3>{0, 12, 0}));
      EXPECT_EQ(bends(shape)[1], 12 * n);
      EXPECT_EQ(bends(shape)[0], static_cast<std::ptrdiff_t>(shape.edges.size()) - 12 * n);
      expect_same_solid(merged, mesh);
    }
  }
}

TEST(CoplanarFaces, OfAConcaveBlockBecomeConcavePolygons) {
  Random random(4);
  for (int i = 0; i < 20;
       ++i) {  // three of its corners stand in a row, as well as turned numbers do
    const TriangleMesh mesh = transformed(l_block(), Pose{Vec3::Zero(), random.rotation()});
    const SpheroPolyhedron merged = merge_coplanar_faces(make_sphero_polyhedron(mesh, 0.0));
    EXPECT_EQ(counts(merged), (Counts{12, 18, 8}));
    EXPECT_EQ(bends(merged), (std::array<std::ptrdiff_t, 3>{0, 17, 1}));
    expect_same_solid(merged, mesh);
    const SpheroPolyhedron again =
        merge_coplanar_faces(make_sphero_polyhedron(core_mesh(merged), 0.0));
    EXPECT_EQ(counts(again), counts(merged));
  }
}

TEST(CoplanarFaces, TakeInTrianglesWithoutHeight) {
  // The floor of the L as a file may have it: three corners in a row make a triangle.
  const std::vector<Vec2> outline = {{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
  const TriangleMesh mesh = prism(outline, {{0, 1, 5}, {1, 3, 5}, {1, 2, 3}, {3, 4, 5}});
  Random random(4);
  for (int i = 0; i < 20; ++i) {
    const TriangleMesh turned = transformed(mesh, Pose{Vec3::Zero(), random.rotation()});
    EXPECT_EQ(counts(merge_coplanar_faces(make_sphero_polyhedron(turned, 0.0))),
              (Counts{12, 18, 8}));
  }
}

TEST(CoplanarFaces, PolygonsStartAtAConvexCornerThatGivesTheirNormal) {
  for (const TriangleMesh& mesh : {box_mesh({1, 1, 1}, 3), l_block()}) {
    const SpheroPolyhedron merged = merge_coplanar_faces(make_sphero_polyhedron(mesh, 0.0));
    for (const SpheroPolyhedron::Face& face : merged.faces) {
      const Vec3 ahead = merged.vertices[face[1]] - merged.vertices[face[0]];
      const Vec3 back = merged.vertices[face.back()] - merged.vertices[face[0]];
      EXPECT_LT((ahead.cross(back).normalized() - face_normal(merged, face)).norm(), 1e-12);
    }
  }
}

TEST(CoplanarFaces, AroundAHoleStayAsTheyAre) {
  const TriangleMesh mesh = frame();
  const SpheroPolyhedron merged = merge_coplanar_faces(make_sphero_polyhedron(mesh, 0.0));
  EXPECT_EQ(counts(merged), (Counts{16, 40, 24}));  // eight walls, two ends of eight triangles
  EXPECT_EQ(bends(merged), (std::array<std::ptrdiff_t, 3>{16, 20, 4}));
  expect_same_solid(merged, mesh);
}

TEST(CoplanarFaces, ACornerOnAStraightSideThatOtherFacesNeedStays) {
  // Half of one wall leans in; vertex 1 lies on a straight side of the floor, where the wall that
  // closes the step ends.
  SpheroPolyhedron step;
  step.vertices = {{0, 0, 0}, {1, 0, 0},   {2, 0, 0},   {2, 1, 0}, {0, 1, 0}, {0, 0, 1},
                   {1, 0, 1}, {1, 0.5, 1}, {2, 0.5, 1}, {2, 1, 1}, {0, 1, 1}};
  step.faces = {{0, 4, 3, 2, 1}, {0, 1, 6, 5},  {1, 7, 6},     {1, 2, 8, 7},
                {2, 3, 9, 8},    {3, 4, 10, 9}, {4, 0, 5, 10}, {5, 6, 7, 8, 9, 10}};
  step.edges = face_edges(step.faces);
  const TriangleMesh mesh = core_mesh(step);
  const SpheroPolyhedron merged = merge_coplanar_faces(make_sphero_polyhedron(mesh, 0.0));
  EXPECT_EQ(counts(merged), (Counts{11, 17, 8}));
  EXPECT_EQ(merged.edges, step.edges);
  expect_same_solid(merged, mesh);
}

TEST(CoplanarFaces, HeightsAboveTheFlatnessKeepFacesApart) {
  const std::vector<Vec2> square = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  TriangleMesh roof = prism(square, {{0, 1, 2}, {0, 2, 3}});
  std::erase_if(roof.triangles,
                [](const auto& t) { return *std::min_element(&t[0], &t[0] + 3) > 3; });
  roof.vertices.push_back({0.5, 0.5, 1.0 + 1e-6});
  for (std::uint32_t i = 0; i < 4; ++i) roof.triangles.push_back({4 + i, 4 + (i + 1) % 4, 8});
  const SpheroPolyhedron shape = make_sphero_polyhedron(roof, 0.0);
  EXPECT_EQ(counts(merge_coplanar_faces(shape)), (Counts{9, 16, 9}));
  EXPECT_EQ(counts(merge_coplanar_faces(shape, 1e-5)), (Counts{8, 12, 6}));
}

TEST(CoplanarFaces, RocksWithoutPlanesStayAsTheyAre) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const SpheroPolyhedron rock = make_sphero_polyhedron(random_rock(seed, 3), 0.02);
    const SpheroPolyhedron merged = merge_coplanar_faces(rock);
    EXPECT_EQ(merged.vertices, rock.vertices);
    EXPECT_EQ(merged.edges, rock.edges);
    EXPECT_EQ(merged.faces.size(), rock.faces.size());
  }
}

TEST(CoplanarFaces, ABallHasNone) {
  SpheroPolyhedron ball;
  ball.vertices = {{1, 2, 3}};
  ball.radius = 0.5;
  EXPECT_EQ(counts(merge_coplanar_faces(ball)), (Counts{1, 0, 0}));
}

TEST(EdgeConvexity, FollowsTheAngleBetweenTheFaces) {
  const Vec3 up = Vec3::UnitZ();
  for (const double angle : {-3.0, -1.0, -1e-6, 1e-6, 1.0, 3.0}) {  // > 0: falls away
    const Vec3 into(std::cos(angle), 0.0, -std::sin(angle));
    const Vec3 normal(std::sin(angle), 0.0, std::cos(angle));
    EXPECT_EQ(edge_convexity(up, normal, into),
              angle > 0 ? EdgeConvexity::kConvex : EdgeConvexity::kReflex);
  }
  EXPECT_EQ(edge_convexity(up, up, Vec3::UnitX()), EdgeConvexity::kFlat);
  EXPECT_EQ(edge_convexity(up, Vec3(-up), Vec3(-Vec3::UnitX())),
            EdgeConvexity::kConvex);  // a knife's edge
}

}  // namespace
}  // namespace clast
