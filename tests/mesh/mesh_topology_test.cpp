#include "mesh/mesh_topology.hpp"

#include <gtest/gtest.h>

#include <set>

#include "core/error.hpp"
#include "tests/shapes/shape_samples.hpp"

namespace clast {
namespace {

TEST(TriangleMesh, BoundsAreaAndRigidMotionOfABox) {
  const TriangleMesh box = box_mesh({1.0, 2.0, 3.0}, 4);
  EXPECT_DOUBLE_EQ(bounds(box).diagonal(), std::sqrt(14.0));
  EXPECT_NEAR(surface_area(box), 22.0, 1e-13);
  Random random(3);
  const Pose pose{Vec3(10, -4, 5), random.rotation()};
  const TriangleMesh moved = transformed(box, pose);
  EXPECT_NEAR(surface_area(moved), 22.0, 1e-12);
  EXPECT_NEAR(enclosed_volume(moved), 6.0, 1e-12);
  EXPECT_NEAR(enclosed_volume(scaled(moved, 2.0)), 48.0, 1e-11);
}

TEST(TriangleMesh, MergingRenumbersTheSecondMesh) {
  const TriangleMesh both = merged(tetrahedron(), box_mesh({1, 1, 1}));
  EXPECT_EQ(both.triangles.size(), 16u);
  EXPECT_EQ(inspect_mesh(both).components, 2u);
  EXPECT_TRUE(inspect_mesh(both).is_closed());
}

TEST(TriangleMesh, ScaleThatIsNotPositiveIsRefused) {
  EXPECT_THROW(scaled(tetrahedron(), 0.0), InputError);
  EXPECT_THROW(scaled(tetrahedron(), -1.0), InputError);
  EXPECT_THROW(scaled(tetrahedron(), std::nan("")), InputError);
}

TEST(MeshTopology, BoxIsClosedWithEulerTwo) {
  for (const int n : {1, 2, 7}) {
    const TriangleMesh box = box_mesh({1, 2, 3}, n);
    const MeshReport report = inspect_mesh(box);
    EXPECT_TRUE(report.is_closed() && report.is_oriented());
    EXPECT_EQ(report.triangles, 12u * n * n);
    EXPECT_EQ(report.vertices, 6u * n * n + 2);
    EXPECT_EQ(report.edges, 18u * n * n);
    EXPECT_EQ(report.euler_characteristic, 2);
    EXPECT_EQ(report.components, 1u);
    EXPECT_EQ(report.summary(), "closed");
  }
}

TEST(MeshTopology, MissingTriangleIsOneLoopInFillingDirection) {
  TriangleMesh open = tetrahedron();
  const TriangleMesh::Triangle taken = open.triangles.back();
  open.triangles.pop_back();
  EXPECT_EQ(inspect_mesh(open).summary(), "3 boundary edges in 1 loop");
  const auto loops = boundary_loops(open);
  ASSERT_EQ(loops.size(), 1u);
  ASSERT_EQ(loops[0].size(), 3u);
  open.triangles.push_back({loops[0][0], loops[0][1], loops[0][2]});
  EXPECT_TRUE(inspect_mesh(open).is_closed() && inspect_mesh(open).is_oriented());
  EXPECT_EQ(std::set<std::uint32_t>(taken.begin(), taken.end()),
            std::set<std::uint32_t>(loops[0].begin(), loops[0].end()));
}

TEST(MeshTopology, LoopsThatTouchAtAVertexAreSplit) {
  TriangleMesh sheet = box_mesh({1, 1, 1}, 4);
  // Two holes of one triangle each around the middle vertex of the face x = 0.
  std::uint32_t centre = 0;
  for (std::uint32_t v = 0; v < sheet.vertices.size(); ++v) {
    if ((sheet.vertices[v] - Vec3(0, 0.5, 0.5)).norm() < 1e-12) centre = v;
  }
  std::vector<std::size_t> at_centre;
  for (std::size_t t = 0; t < sheet.triangles.size(); ++t) {
    for (const std::uint32_t v : sheet.triangles[t]) {
      if (v == centre) at_centre.push_back(t);
    }
  }
  ASSERT_EQ(at_centre.size(), 6u);
  std::size_t second = 0;  // one that shares only the centre with the first
  for (const std::size_t t : at_centre) {
    int shared = 0;
    for (const std::uint32_t v : sheet.triangles[t]) {
      for (const std::uint32_t w : sheet.triangles[at_centre[0]]) shared += v == w;
    }
    if (shared == 1) second = t;
  }
  ASSERT_GT(second, at_centre[0]);
  sheet.triangles.erase(sheet.triangles.begin() + static_cast<std::ptrdiff_t>(second));
  sheet.triangles.erase(sheet.triangles.begin() + static_cast<std::ptrdiff_t>(at_centre[0]));
  const auto loops = boundary_loops(sheet);
  ASSERT_EQ(loops.size(), 2u);
  EXPECT_EQ(loops[0].size(), 3u);
  EXPECT_EQ(loops[1].size(), 3u);
  EXPECT_EQ(inspect_mesh(sheet).boundary_loops, 2u);
}

TEST(MeshTopology, DefectsAreCounted) {
  TriangleMesh flipped = tetrahedron();
  std::swap(flipped.triangles[0][0], flipped.triangles[0][1]);
  EXPECT_EQ(inspect_mesh(flipped).misoriented_edges, 3u);
  EXPECT_TRUE(inspect_mesh(flipped).is_closed());
  EXPECT_FALSE(inspect_mesh(flipped).is_oriented());

  TriangleMesh fin = tetrahedron();
  fin.vertices.push_back({2, 2, 2});
  fin.triangles.push_back({0, 1, 4});
  EXPECT_EQ(inspect_mesh(fin).non_manifold_edges, 1u);
  EXPECT_EQ(inspect_mesh(fin).boundary_edges, 2u);
  EXPECT_FALSE(inspect_mesh(fin).is_closed());

  TriangleMesh flat = tetrahedron();
  flat.triangles.push_back({1, 1, 2});
  EXPECT_EQ(inspect_mesh(flat).degenerate_triangles, 1u);
  EXPECT_TRUE(inspect_mesh(flat).is_closed());
  flat.vertices.push_back({0.5, 0, 0});
  flat.triangles.push_back({0, 4, 1});
  EXPECT_EQ(inspect_mesh(flat).degenerate_triangles, 2u);
}

TEST(MeshTopology, TwoSolidsAtOneVertexArePinchedAndTwoPieces) {
  TriangleMesh two = tetrahedron();
  two.vertices.insert(two.vertices.end(), {{-1, 0, 0}, {0, -1, 0}, {0, 0, -1}});
  two.triangles.insert(two.triangles.end(), {{0, 4, 5}, {0, 6, 4}, {4, 6, 5}, {0, 5, 6}});
  const MeshReport report = inspect_mesh(two);
  EXPECT_TRUE(report.is_closed());
  EXPECT_EQ(report.pinched_vertices, 1u);
  EXPECT_EQ(report.components, 2u);
  EXPECT_EQ(report.summary(), "1 pinched vertex, 2 components");
}

TEST(MeshTopology, ComponentsAreNumberedByFirstTriangle) {
  TriangleMesh mixed = merged(tetrahedron(), tetrahedron());
  std::swap(mixed.triangles[1], mixed.triangles[5]);
  const std::vector<std::uint32_t> expected = {0, 1, 0, 0, 1, 0, 1, 1};
  EXPECT_EQ(triangle_components(mixed), expected);
}

TEST(MeshTopology, VertexNumberOutOfRangeIsRefused) {
  TriangleMesh bad = tetrahedron();
  bad.triangles[2][1] = 4;
  EXPECT_THROW(inspect_mesh(bad), GeometryError);
  EXPECT_THROW(boundary_loops(bad), GeometryError);
}

TEST(MeshTopology, NoTrianglesIsNotClosed) {
  EXPECT_FALSE(inspect_mesh({}).is_closed());
  EXPECT_EQ(inspect_mesh({}).summary(), "no triangles");
}

class RandomRocks : public testing::TestWithParam<int> {};

TEST_P(RandomRocks, LoseTrianglesAndCountTheirOpenEdges) {
  TriangleMesh rock = random_rock(GetParam());
  Random random(GetParam() + 100);
  for (int i = 0; i < 20; ++i) {
    rock.triangles.erase(rock.triangles.begin() +
                         static_cast<std::ptrdiff_t>(random.uniform_index(rock.triangles.size())));
  }
  const MeshReport report = inspect_mesh(rock);
  std::size_t in_loops = 0;
  for (const auto& loop : boundary_loops(rock)) {
    in_loops += loop.size();
    EXPECT_EQ(std::set<std::uint32_t>(loop.begin(), loop.end()).size(), loop.size());
  }
  EXPECT_EQ(in_loops, report.boundary_edges);
  EXPECT_EQ(3 * report.triangles, 2 * report.edges - report.boundary_edges);
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomRocks, testing::Range(0, 20));

}  // namespace
}  // namespace clast
