#include "mesh/weld.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "core/error.hpp"
#include "mesh/mesh_topology.hpp"
#include "tests/shapes/shape_samples.hpp"

namespace clast {
namespace {

/// Every triangle with vertices of its own, as STL stores it, each moved by up to `shift`.
TriangleMesh exploded(const TriangleMesh& mesh, double shift = 0.0) {
  TriangleMesh soup;
  Random random(1);
  for (const TriangleMesh::Triangle& t : mesh.triangles) {
    const auto first = static_cast<std::uint32_t>(soup.vertices.size());
    for (const std::uint32_t v : t) {
      soup.vertices.push_back(mesh.vertices[v] + shift * random.uniform() * random.unit_vector());
    }
    soup.triangles.push_back({first, first + 1, first + 2});
  }
  return soup;
}

TEST(Weld, SoupBecomesTheMeshAgain) {
  const TriangleMesh box = box_mesh({1, 2, 3}, 5);
  for (const double tolerance : {0.0, 1e-6}) {
    const TriangleMesh back = weld_vertices(exploded(box), tolerance);
    EXPECT_EQ(back.vertices.size(), box.vertices.size());
    EXPECT_TRUE(inspect_mesh(back).is_closed());
    EXPECT_NEAR(enclosed_volume(back), 6.0, tolerance == 0.0 ? 1e-13 : 1e-4);
  }
}

TEST(Weld, NearVerticesJoinOnlyWithinTheTolerance) {
  for (const Vec3& offset : {Vec3(0, 0, 0), Vec3(888600, 6671300, 200)}) {
    const TriangleMesh soup =
        transformed(exploded(random_rock(3), 0.4e-5), Pose{offset, Quat::Identity()});
    EXPECT_TRUE(inspect_mesh(weld_vertices(soup, 1e-5)).is_closed());
    EXPECT_FALSE(inspect_mesh(weld_vertices(soup, 1e-7)).is_closed());
    EXPECT_FALSE(inspect_mesh(weld_vertices(soup, 0.0)).is_closed());
  }
}

TEST(Weld, PositionIsThatOfTheFirstVertex) {
  TriangleMesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1e-7, 0, 0}, {1, 1, 0}};
  mesh.triangles = {{0, 1, 2}, {3, 4, 2}};
  const TriangleMesh result = weld_vertices(mesh, 1e-6);
  EXPECT_EQ(result.vertices.size(), 4u);
  EXPECT_EQ(result.triangles[1][0], 0u);
  EXPECT_EQ(result.vertices[0], Vec3(0, 0, 0));
}

TEST(Weld, CollapsedAndRepeatedTrianglesAndUnusedVerticesGo) {
  TriangleMesh mesh = tetrahedron();
  mesh.vertices.push_back({9, 9, 9});
  mesh.vertices.push_back({1, 0, 0});
  mesh.triangles.push_back({1, 5, 2});  // collapses
  mesh.triangles.push_back({2, 1, 0});  // the first triangle again, started elsewhere
  const TriangleMesh result = weld_vertices(mesh, 0.0);
  EXPECT_EQ(result.triangles, tetrahedron().triangles);
  EXPECT_EQ(result.vertices, tetrahedron().vertices);
}

TEST(Weld, ToleranceThatIsNegativeOrNotFiniteIsRefused) {
  EXPECT_THROW(weld_vertices(tetrahedron(), -1e-9), InputError);
  EXPECT_THROW(weld_vertices(tetrahedron(), std::nan("")), InputError);
  EXPECT_THROW(weld_vertices(tetrahedron(), std::numeric_limits<double>::infinity()), InputError);
}

TEST(Weld, TargetsStayThemselves) {
  const std::vector<Vec3> row = {{0, 0, 0}, {0.9, 0, 0}, {1.8, 0, 0}, {0, 0, 0}, {2.5, 0, 0}};
  EXPECT_EQ(find_weld_targets(row, 1.0), (std::vector<std::uint32_t>{0, 0, 2, 0, 2}));
  EXPECT_EQ(find_weld_targets(row, 0.0), (std::vector<std::uint32_t>{0, 1, 2, 0, 4}));
}

TEST(Weld, CopiesOfATriangleAreFoundByTurn) {
  const std::vector<TriangleMesh::Triangle> triangles = {
      {4, 5, 6}, {0, 1, 2}, {2, 0, 1}, {1, 0, 2}};
  const std::vector<DuplicateTriangle> same =
      find_duplicate_triangles(triangles, WindingMatch::kSame);
  ASSERT_EQ(same.size(), 1u);
  EXPECT_EQ(same[0].first, 1u);
  EXPECT_EQ(same[0].duplicate, 2u);
  const std::vector<DuplicateTriangle> either =
      find_duplicate_triangles(triangles, WindingMatch::kEither);
  ASSERT_EQ(either.size(), 2u);
  EXPECT_EQ(either[1].first, 2u);
  EXPECT_EQ(either[1].duplicate, 3u);
}

TEST(Weld, EmptyMeshStaysEmpty) { EXPECT_TRUE(weld_vertices({}, 0.1).vertices.empty()); }

}  // namespace
}  // namespace clast
