#include "reconstruct/repair/non_manifold_split.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <vector>

#include "mesh/mesh_topology.hpp"
#include "mesh/triangle_geometry.hpp"

namespace clast {
namespace {

using Corners = std::array<std::uint32_t, 4>;

/// The surface of tetrahedra that share vertices, outward.
TriangleMesh surface_of(const std::vector<Vec3>& vertices, const std::vector<Corners>& bodies) {
  std::vector<TriangleMesh::Triangle> faces;
  for (const Corners& c : bodies) {
    const Vec3 middle = (vertices[c[0]] + vertices[c[1]] + vertices[c[2]] + vertices[c[3]]) / 4.0;
    for (std::size_t k = 0; k < 4; ++k) {
      TriangleMesh::Triangle t = {c[(k + 1) % 4], c[(k + 2) % 4], c[(k + 3) % 4]};
      const Vec3 normal = (vertices[t[1]] - vertices[t[0]]).cross(vertices[t[2]] - vertices[t[0]]);
      if (normal.dot(vertices[t[0]] - middle) < 0.0) std::swap(t[1], t[2]);
      faces.push_back(t);
    }
  }
  const auto key = [](TriangleMesh::Triangle t) {
    std::sort(t.begin(), t.end());
    return t;
  };
  std::multiset<TriangleMesh::Triangle> all;
  for (const TriangleMesh::Triangle& t : faces) all.insert(key(t));
  std::erase_if(faces, [&](const TriangleMesh::Triangle& t) { return all.count(key(t)) == 2; });
  return {vertices, faces};
}

/// Six wedges about the edge from 0 to 1, of which two, opposite each other, are missing; above and
/// below them the body goes on all round. That edge, and the outer ones of the two gaps, have four
/// triangles, and the sheets meet at both of their ends too.
TriangleMesh body_with_two_wedges_missing() {
  std::vector<Vec3> vertices = {{0, 0, 0.3}, {0, 0, -0.3}, {0, 0, 1}, {0, 0, -1}};
  for (int i = 0; i < 6; ++i)
    vertices.emplace_back(std::cos(i * kPi / 3), std::sin(i * kPi / 3), 0);
  std::vector<Corners> bodies;
  for (std::uint32_t i = 0; i < 6; ++i) {
    const std::uint32_t p = 4 + i, q = 4 + (i + 1) % 6;
    bodies.push_back({0, 2, p, q});
    bodies.push_back({1, 3, p, q});
    if (i % 3 != 0) bodies.push_back({0, 1, p, q});
  }
  return surface_of(vertices, bodies);
}

TEST(TouchingSheets, StayClosedWhereTheyMeetAtBothEndsOfAnEdgeToo) {
  TriangleMesh mesh = body_with_two_wedges_missing();
  const MeshReport before = inspect_mesh(mesh);
  ASSERT_EQ(before.non_manifold_edges, 3u);
  ASSERT_EQ(before.boundary_edges, 0u);
  const TriangleMesh whole = mesh;

  const reconstruct_detail::EdgeSplitResult touching =
      reconstruct_detail::split_non_manifold_edges(mesh);
  reconstruct_detail::split_non_manifold_vertices(mesh);

  EXPECT_EQ(touching.split.count, 3u);
  const MeshReport after = inspect_mesh(mesh);
  EXPECT_TRUE(after.is_closed() && after.is_oriented()) << after.summary();
  EXPECT_EQ(after.pinched_vertices, 0u);
  EXPECT_NEAR(signed_volume(mesh), signed_volume(whole), 1e-15);
  EXPECT_NEAR(surface_area(mesh), surface_area(whole), 1e-14);
  // Each part lies in the triangle that it is said to come from.
  ASSERT_EQ(touching.original_triangle.size(), mesh.triangles.size());
  std::vector<double> areas(whole.triangles.size(), 0.0);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    areas[touching.original_triangle[t]] += triangle_area(mesh, mesh.triangles[t]);
    const Vec3 normal =
        doubled_area_vector(whole, whole.triangles[touching.original_triangle[t]]).normalized();
    EXPECT_NEAR(normal.dot(doubled_area_vector(mesh, mesh.triangles[t]).normalized()), 1.0, 1e-14);
  }
  for (std::size_t t = 0; t < areas.size(); ++t) {
    EXPECT_NEAR(areas[t], triangle_area(whole, whole.triangles[t]), 1e-15);
  }
}

TEST(TouchingSheets, OfTwoBodiesThatShareAnEdgeEachKeepsItsOwn) {
  const std::vector<Vec3> vertices = {{0, 0, 0},     {0, 0, 1},    {1, 0, 0.5},
                                      {1, 0.5, 0.5}, {-1, 0, 0.5}, {-1, 0.5, 0.5}};
  TriangleMesh mesh = surface_of(vertices, {{0, 1, 2, 3}, {0, 1, 4, 5}});
  ASSERT_EQ(inspect_mesh(mesh).non_manifold_edges, 1u);
  const std::size_t triangles = mesh.triangles.size();
  reconstruct_detail::split_non_manifold_edges(mesh);
  const MeshReport after = inspect_mesh(mesh);
  EXPECT_TRUE(after.is_closed() && after.is_oriented()) << after.summary();
  EXPECT_EQ(after.components, 2u);
  EXPECT_EQ(mesh.triangles.size(), triangles) << "parted at the ends: nothing needs to be cut";
}

// Two more triangles on one of the faces, one turned over: cutting would go on without an end.
TEST(TouchingSheets, TrianglesThatLieOnOneAnotherAreDropped) {
  const std::vector<Vec3> vertices = {{0, 0, 0}, {0, 0, 1}, {1, 0, 0.5}, {1, 0.5, 0.5}};
  TriangleMesh mesh = surface_of(vertices, {{0, 1, 2, 3}});
  const TriangleMesh::Triangle t = mesh.triangles[0];
  mesh.triangles.push_back({t[1], t[0], t[2]});
  mesh.triangles.push_back(t);
  const TriangleMesh whole = mesh;
  const reconstruct_detail::EdgeSplitResult touching =
      reconstruct_detail::split_non_manifold_edges(mesh);
  EXPECT_EQ(touching.original_triangle.size(), mesh.triangles.size());
  EXPECT_EQ(inspect_mesh(mesh).non_manifold_edges, 0u);
  EXPECT_LE(surface_area(mesh), surface_area(whole));
}

}  // namespace
}  // namespace clast
