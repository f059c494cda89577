#include "mesh/triangle_neighbours.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "mesh/mesh_topology.hpp"
#include "mesh/sub_mesh.hpp"
#include "mesh/vertex_corners.hpp"
#include "tests/shapes/shape_samples.hpp"

namespace clast {
namespace {

/// Two squares of two triangles each that stand on one edge of a third, and meet nothing else.
TriangleMesh three_sheets() {
  TriangleMesh mesh;
  mesh.vertices = {{0, 0, 0}, {0, 1, 0}};
  for (const Vec3& out : {Vec3(1, 0, 0), Vec3(-1, 0, 0), Vec3(0, 0, 1)}) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.push_back(out);
    mesh.vertices.push_back(out + Vec3(0, 1, 0));
    mesh.triangles.push_back({0, first, 1});
    mesh.triangles.push_back({first, first + 1, 1});
  }
  return mesh;
}

/// A band of `n` squares that closes with half a turn.
TriangleMesh moebius_band(std::uint32_t n) {
  TriangleMesh band;
  for (std::uint32_t i = 0; i < n; ++i) {
    const double angle = 2.0 * kPi * i / n;
    const Vec3 out(std::cos(angle), std::sin(angle), 0.0);
    const Vec3 across = std::cos(0.5 * angle) * out + std::sin(0.5 * angle) * Vec3::UnitZ();
    band.vertices.push_back(out - 0.2 * across);
    band.vertices.push_back(out + 0.2 * across);
  }
  for (std::uint32_t i = 0; i < n; ++i) {
    const bool last = i + 1 == n;
    const std::uint32_t a = 2 * i, b = a + 1, c = last ? 1 : a + 2, d = last ? 0 : a + 3;
    band.triangles.push_back({a, b, c});
    band.triangles.push_back({b, d, c});
  }
  return band;
}

TEST(HalfEdges, EverySideIsKnownWithItsCorners) {
  const TriangleMesh rock = random_rock(2);
  const std::vector<HalfEdge> sorted = sorted_half_edges(rock);
  ASSERT_EQ(sorted.size(), 3 * rock.triangles.size());
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    const HalfEdge& side = sorted[i];
    const TriangleMesh::Triangle& t = rock.triangles[side.triangle];
    EXPECT_EQ(t[side.side], side.from());
    EXPECT_EQ(t[(side.side + 1) % 3], side.to());
    EXPECT_EQ(side.low_corner() / 3, side.triangle);
    EXPECT_EQ(t[side.low_corner() % 3], side.low);
    EXPECT_EQ(t[side.high_corner() % 3], side.high);
    EXPECT_EQ(t[side.opposite_corner() % 3], t[0] + t[1] + t[2] - side.low - side.high);
    if (i == 0) continue;
    const auto key = [](const HalfEdge& s) { return std::array{s.low, s.high, s.triangle}; };
    EXPECT_LT(key(sorted[i - 1]), key(side));
  }
}

TEST(HalfEdges, OfPolygonsPairUpOnAClosedSurface) {
  const std::vector<std::vector<std::uint32_t>> pyramid = {
      {3, 2, 1, 0}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};
  std::size_t edges = 0;
  for_each_edge(sorted_half_edges(pyramid), [&](std::span<const HalfEdge> sides) {
    ++edges;
    EXPECT_TRUE(is_interior_edge(sides));
    for (const HalfEdge& side : sides) {
      EXPECT_EQ(pyramid[side.triangle][side.side], side.from());
    }
  });
  EXPECT_EQ(edges, 8u);
  const std::vector<std::vector<std::uint32_t>> pinched = {{0, 1, 1, 2}};
  EXPECT_EQ(sorted_half_edges(pinched).size(), 4u);
}

TEST(TriangleNeighbours, AreMutualAndShareTheSide) {
  TriangleMesh rock = random_rock(4);
  rock.triangles.resize(rock.triangles.size() - 7);
  const TriangleNeighbours links = triangle_neighbours(rock);
  EXPECT_EQ(links.border_edges, inspect_mesh(rock).boundary_edges);
  EXPECT_EQ(links.non_manifold_edges, 0u);
  std::size_t open = 0;
  for (std::uint32_t t = 0; t < rock.triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = rock.triangles[t][k], b = rock.triangles[t][(k + 1) % 3];
      EXPECT_EQ(find_edge_side(rock.triangles[t], b, a), k);
      open += links.is_border_side(t, k);
      if (links.is_border_side(t, k)) continue;
      const std::uint32_t other = links.neighbour[t][k];
      EXPECT_EQ(links.neighbour[other][find_edge_side(rock.triangles[other], a, b)], t);
    }
  }
  EXPECT_EQ(open, links.border_edges);
  EXPECT_EQ(find_edge_side({0, 1, 2}, 0, 3), 3u);
}

TEST(TriangleNeighbours, PartsThatMeetAtACrowdedEdgeAreApart) {
  const TriangleMesh sheets = three_sheets();
  const TriangleNeighbours links = triangle_neighbours(sheets);
  EXPECT_EQ(links.non_manifold_edges, 1u);
  EXPECT_EQ(links.first_non_manifold_edge, (EdgeKey{0, 1}));
  EXPECT_EQ(manifold_components(links), (std::vector<std::uint32_t>{0, 0, 1, 1, 2, 2}));
  EXPECT_EQ(inspect_mesh(sheets).components, 1u);
}

class TurnedRocks : public testing::TestWithParam<int> {};

TEST_P(TurnedRocks, AreFoundToDisagreeWhereTheyWereTurned) {
  TriangleMesh rock = merged(random_rock(GetParam()), random_rock(GetParam() + 50));
  const TriangleMesh sound = rock;
  Random random(GetParam());
  for (int i = 0; i < 40; ++i) {
    TriangleMesh::Triangle& t = rock.triangles[random.uniform_index(rock.triangles.size())];
    std::swap(t[1], t[2]);
  }
  const ConsistentOrientation facing = find_consistent_orientation(rock, triangle_neighbours(rock));
  EXPECT_FALSE(facing.conflict_vertex);
  ASSERT_EQ(facing.components.size(), 2u);
  for (const std::vector<std::uint32_t>& component : facing.components) {
    EXPECT_EQ(component.front(), *std::min_element(component.begin(), component.end()));
    const bool first_turned =
        rock.triangles[component.front()] != sound.triangles[component.front()];
    for (const std::uint32_t t : component) {
      EXPECT_EQ(facing.is_flipped[t] != first_turned, rock.triangles[t] != sound.triangles[t]);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, TurnedRocks, testing::Range(0, 10));

TEST(ConsistentOrientation, ABandWithHalfATurnIsOneSided) {
  const TriangleMesh band = moebius_band(9);
  const std::optional<std::uint32_t> conflict =
      find_consistent_orientation(band, triangle_neighbours(band)).conflict_vertex;
  ASSERT_TRUE(conflict);
  EXPECT_LT(*conflict, band.vertices.size());
}

TEST(VertexCorners, AreAllThatLieAtAVertexAscending) {
  const TriangleMesh rock = random_rock(6);
  const VertexCorners corners(rock);
  std::size_t count = 0;
  for (std::uint32_t v = 0; v < rock.vertices.size(); ++v) {
    count += corners.corners_of(v).size();
    EXPECT_TRUE(std::is_sorted(corners.corners_of(v).begin(), corners.corners_of(v).end()));
    for (const std::uint32_t c : corners.corners_of(v)) EXPECT_EQ(rock.triangles[c / 3][c % 3], v);
  }
  EXPECT_EQ(count, 3 * rock.triangles.size());
}

TEST(SubMesh, KeepsOrdersAndDropsWhatNothingUses) {
  const TriangleMesh both = merged(tetrahedron(), scaled(tetrahedron(), 2.0));
  const TriangleMesh second =
      extract_triangles(both, {false, false, false, false, true, true, true, true});
  EXPECT_EQ(second.vertices, scaled(tetrahedron(), 2.0).vertices);
  EXPECT_EQ(second.triangles, tetrahedron().triangles);
  EXPECT_TRUE(extract_triangles(both, std::vector<bool>(8, false)).vertices.empty());
}

}  // namespace
}  // namespace clast
