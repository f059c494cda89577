#include "shapes/outer_surface.hpp"

#include <gtest/gtest.h>

#include "core/error.hpp"
#include "mesh/mesh_topology.hpp"
#include "mesh/self_intersection.hpp"
#include "mesh/triangle_tree.hpp"
#include "tests/shapes/shape_samples.hpp"

namespace clast {
namespace {

void expect_clean(const TriangleMesh& skin, long euler) {
  const MeshReport report = inspect_mesh(skin);
  EXPECT_TRUE(report.is_closed() && report.is_oriented()) << report.summary();
  EXPECT_EQ(report.pinched_vertices, 0u);
  EXPECT_EQ(report.components, 1u);
  EXPECT_EQ(report.euler_characteristic, euler);
  EXPECT_TRUE(find_self_intersections(skin).empty());
  EXPECT_GT(enclosed_volume(skin), 0.0);
}

TEST(OuterSkin, OfTheLBlockIsCleanAndItsVolumeTendsToTheFormula) {
  const double r = 0.3;
  const double exact = 3.0 + 14.0 * r + (21.0 * kPi / 4.0 - 1.0) * r * r +
                       4.0 / 3.0 * (5.0 * kPi / 4.0 - 1.0) * r * r * r;
  double error_before = 0.0;
  for (const int segments : {2, 4, 8}) {
    const TriangleMesh skin = outer_surface_mesh(make_sphero_polyhedron(l_block(), r), segments);
    expect_clean(skin, 2);
    const double error = 1.0 - enclosed_volume(skin) / exact;
    EXPECT_GT(error, 0.0) << segments;
    // Second order in the size of a piece.
    EXPECT_TRUE(error_before == 0.0 || error < 0.35 * error_before) << segments << ": " << error;
    error_before = error;
  }
  EXPECT_LT(error_before, 2e-3);
}

TEST(OuterSkin, OfConcaveRocksIsCleanWithItsVerticesAtTheRadius) {
  for (std::uint64_t seed = 0; seed < 2; ++seed) {
    const TriangleMesh rock = random_rock(seed, 2, 0.2);
    const double r = 0.1;
    const TriangleMesh skin = outer_surface_mesh(make_sphero_polyhedron(rock, r), 2);
    expect_clean(skin, 2);
    const TriangleTree tree(rock);
    for (const Vec3& point : skin.vertices) EXPECT_NEAR(tree.signed_distance(point), r, 1e-3 * r);
  }
}

TEST(OuterSkin, KeepsAHoleThroughTheBlock) {
  expect_clean(outer_surface_mesh(make_sphero_polyhedron(frame(), 0.2), 2), 0);
}

TEST(OuterSkin, OfConvexAndOfSharpBodiesIsTheirSkin) {
  const SpheroPolyhedron box = make_sphero_polyhedron(box_mesh({1, 2, 3}), 0.2);
  EXPECT_EQ(outer_surface_mesh(box).vertices, rounded_surface_mesh(box).vertices);
  EXPECT_EQ(outer_surface_mesh(make_sphero_polyhedron(l_block(), 0.0)).vertices,
            l_block().vertices);
}

TEST(OuterSkin, IsTheSameEachTime) {
  const SpheroPolyhedron shape = make_sphero_polyhedron(random_rock(9, 1, 0.3), 0.2);
  const TriangleMesh once = outer_surface_mesh(shape, 2), again = outer_surface_mesh(shape, 2);
  EXPECT_EQ(once.vertices, again.vertices);
  EXPECT_EQ(once.triangles, again.triangles);
}

TEST(OuterSkin, OfAnOpenCoreIsRefused) {
  TriangleMesh open = l_block();
  open.triangles.pop_back();
  EXPECT_THROW(outer_surface_mesh(make_sphero_polyhedron(open, 0.1)), GeometryError);
  EXPECT_THROW(outer_surface_mesh(make_sphero_polyhedron(l_block(), 0.1), 0), InputError);
}

}  // namespace
}  // namespace clast
