/// Torn surfaces: what a few missing triangles left is closed by what is there, not bulged.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "core/error.hpp"
#include "mesh/half_edges.hpp"
#include "mesh/mesh_topology.hpp"
#include "mesh/self_intersection.hpp"
#include "reconstruct/field_scan.hpp"
#include "reconstruct/repair/detail/loop_filling.hpp"
#include "reconstruct/repair/hole_loops.hpp"
#include "reconstruct/repair/holes.hpp"
#include "reconstruct/repair/missing_faces.hpp"
#include "shapes/oriented_box.hpp"
#include "tests/shapes/shape_samples.hpp"
#include "tests/support/cut_blocks.hpp"
#include "tests/support/rock_mesh.hpp"
#include "tests/support/solid_volume.hpp"
#include "tests/support/torn_mesh.hpp"

namespace clast {
namespace {

using Triangle = TriangleMesh::Triangle;

void expect_closed_and_sound(const TriangleMesh& mesh) {
  const MeshReport report = inspect_mesh(mesh);
  EXPECT_TRUE(report.is_closed() && report.is_oriented()) << report.summary();
  EXPECT_EQ(report.pinched_vertices, 0u);
  EXPECT_EQ(report.components, 1u);
  EXPECT_TRUE(find_self_intersections(mesh).empty());
}

/// Largest relative difference of a side of the smallest box.
double box_error(const TriangleMesh& mesh, const TriangleMesh& truth) {
  const Vec3 a = smallest_box(mesh.vertices).lengths, b = smallest_box(truth.vertices).lengths;
  return (a.cwiseQuotient(b) - Vec3::Ones()).cwiseAbs().maxCoeff();
}

/// A vertex of a sphere whose six triangles are numbered around it.
std::vector<std::uint32_t> around(const TriangleMesh& mesh, std::uint32_t vertex) {
  std::vector<std::uint32_t> triangles;
  std::uint32_t next = 0;
  for (std::uint32_t t = 0; t < mesh.triangles.size() && triangles.empty(); ++t) {
    for (int k = 0; k < 3; ++k) {
      if (mesh.triangles[t][k] != vertex) continue;
      triangles = {t};
      next = mesh.triangles[t][(k + 2) % 3];
    }
  }
  for (bool found = true; found;) {
    found = false;
    for (std::uint32_t t = 0; t < mesh.triangles.size() && !found; ++t) {
      for (int k = 0; k < 3; ++k) {
        if (mesh.triangles[t][k] != vertex || mesh.triangles[t][(k + 1) % 3] != next) continue;
        if (t == triangles[0]) return triangles;
        triangles.push_back(t);
        next = mesh.triangles[t][(k + 2) % 3];
        found = true;
        break;
      }
    }
  }
  return triangles;
}

TEST(HoleLoops, TrianglesMissingAroundAVertexAreHolesOfTheirOwn) {
  const TriangleMesh sphere = geodesic_sphere(6);
  const std::uint32_t vertex = sphere.triangles[100][0];
  const std::vector<std::uint32_t> ring = around(sphere, vertex);
  ASSERT_EQ(ring.size(), 6u);
  TriangleMesh torn = sphere;
  for (const std::size_t k : {0u, 2u, 4u}) torn.triangles[ring[k]] = {0, 0, 0};
  std::erase_if(torn.triangles, [](const Triangle& t) { return t[0] == t[1]; });
  const auto loops = reconstruct_detail::find_hole_loops(torn);
  ASSERT_EQ(loops.size(), 3u);
  for (const auto& loop : loops) EXPECT_EQ(loop.size(), 3u);
  EXPECT_EQ(reconstruct_detail::retriangulate_missing_faces(torn).size(), 3u);
  expect_closed_and_sound(torn);
  EXPECT_NEAR(solid_volume(torn), solid_volume(sphere), 1e-12);
}

TEST(HoleLoops, ABorderBesideATriangleOfOppositeOrientationIsClosedOrLeftOut) {
  const TriangleMesh sphere = geodesic_sphere(6);
  TriangleMesh torn = sphere;
  std::erase_if(torn.triangles, [&](const Triangle& t) {
    return std::any_of(t.begin(), t.end(), [&](auto v) { return sphere.vertices[v].z() > 0.9; });
  });
  std::size_t loop_count = 0;
  for (std::size_t t = 0; t < torn.triangles.size(); ++t) {
    TriangleMesh turned = torn;
    std::swap(turned.triangles[t][1], turned.triangles[t][2]);
    std::set<std::pair<std::uint32_t, std::uint32_t>> border;
    for (const HalfEdge& side : sorted_half_edges(turned)) {
      const std::pair edge(side.low, side.high);
      if (!border.insert(edge).second) border.erase(edge);
    }
    for (const auto& loop : reconstruct_detail::find_hole_loops(turned)) {
      ++loop_count;
      for (std::size_t i = 0; i < loop.size(); ++i) {
        EXPECT_TRUE(border.contains(std::minmax(loop[i], loop[(i + 1) % loop.size()])));
      }
    }
    EXPECT_NO_THROW(reconstruct_detail::retriangulate_missing_faces(turned));
  }
  EXPECT_GT(loop_count, torn.triangles.size() / 2);
}

/// A fragment attached in a hole at one corner, whichever way it faces, is part of the surface.
TEST(HoleLoops, AScrapThatHangsAtACornerIsKeptAndTurned) {
  const TriangleMesh sphere = geodesic_sphere(6);
  const std::uint32_t vertex = sphere.triangles[100][0];
  const std::vector<std::uint32_t> ring = around(sphere, vertex);
  const Triangle scrap = sphere.triangles[ring[0]];
  TriangleMesh torn = sphere;
  // All that touch the scrap go, but those at one of its corners other than `vertex`.
  const std::uint32_t kept = scrap[0] == vertex ? scrap[1] : scrap[0];
  std::erase_if(torn.triangles, [&](const Triangle& t) {
    if (t == scrap) return false;
    const auto has = [&](std::uint32_t v) { return t[0] == v || t[1] == v || t[2] == v; };
    std::size_t shared = 0;
    for (const std::uint32_t v : scrap) shared += has(v);
    return shared > 1 || (shared == 1 && !has(kept));
  });
  for (Triangle& t : torn.triangles) {
    if (t == scrap) std::swap(t[1], t[2]);
  }
  EXPECT_EQ(reconstruct_detail::orient_vertex_attached_fragments(torn), 1u);
  const auto loops = reconstruct_detail::find_hole_loops(torn);
  ASSERT_EQ(loops.size(), 1u);
  EXPECT_EQ(std::count(loops[0].begin(), loops[0].end(), kept), 2);
  const std::vector<FilledHole> filled = reconstruct_detail::retriangulate_missing_faces(torn);
  EXPECT_EQ(filled.size(), 1u);
  expect_closed_and_sound(torn);
  EXPECT_NEAR(solid_volume(torn) / solid_volume(sphere), 1.0, 5e-3);
}

TEST(LoopFilling, ASquareIsBetweenItsTwoTriangulations) {
  TriangleMesh saddle;
  saddle.vertices = {{0, 0, 0.2}, {1, 0, 0}, {1, 1, 0.2}, {0, 1, 0}};
  const std::vector<std::uint32_t> loop = {0, 1, 2, 3};
  const std::vector<Vec3> level(4, Vec3::UnitZ());
  const auto filling = reconstruct_detail::triangulate_loop(saddle, loop, level, {});
  ASSERT_TRUE(filling);
  // The two diagonals are a tetrahedron apart: base 1/2, height 0.4.
  EXPECT_NEAR(filling->volume_below + filling->volume_above, 0.5 * 0.4 / 3.0, 1e-12);
  // Joined by an edge already, two corners are not joined again.
  const auto other = reconstruct_detail::triangulate_loop(saddle, loop, level, {{0, 2}});
  ASSERT_TRUE(other);
  for (const Triangle& t : other->triangles) {
    EXPECT_TRUE(std::count(t.begin(), t.end(), 1u) == 1 && std::count(t.begin(), t.end(), 3u) == 1);
  }
  EXPECT_FALSE(reconstruct_detail::triangulate_loop(saddle, loop, level, {{0, 2}, {1, 3}}));
}

/// The cap of a ball lies under the cone of the tangents at its rim: A h / 3 with h the height at
/// which they meet.
TEST(LoopFilling, TangentConesHoldTheCapOfABall) {
  const double angle = 0.6;
  std::vector<Vec3> border, normals;
  constexpr int kCorners = 400;
  for (int i = 0; i < kCorners; ++i) {
    const auto at = [&](double turn) {
      return Vec3(std::sin(angle) * std::cos(turn), std::sin(angle) * std::sin(turn),
                  std::cos(angle));
    };
    border.push_back(at(2.0 * kPi * i / kCorners));
    normals.push_back(at(2.0 * kPi * (i + 0.5) / kCorners));
  }
  const reconstruct_detail::TangentConeVolumes cones =
      reconstruct_detail::tangent_cone_volumes(border, normals);
  const double rim = std::sin(angle), height = rim * std::tan(angle);
  EXPECT_NEAR(cones.above, kPi * rim * rim * height / 3.0, 1e-3 * cones.above);
  EXPECT_EQ(cones.below, 0.0);
  const double cap = 1.0 - std::cos(angle);
  EXPECT_GT(cones.above, kPi * cap * cap * (3.0 - cap) / 3.0);
}

// A sheet that faced inwards was filled seen from the wrong side.
TEST(TornSurface, TheBoundsOfTheHolesAreThoseOfTheWholeWhicheverWayItFaced) {
  const CutBlock cut = cut_blocks(rock_mesh(12, {0.5, 0.4, 0.3}, 3), 1, 7)[0];
  TriangleMesh torn = without_triangles(cut.open, 0.08, 5);
  std::array<double, 2> below{}, above{};
  for (const bool inward : {false, true}) {
    if (inward) {
      for (Triangle& t : torn.triangles) std::swap(t[1], t[2]);
    }
    const FieldBlock block = extract_field_blocks(torn, "torn")[0];
    ASSERT_TRUE(block.underside.has_value());
    const RepairReport& report = block.scan.report;
    for (const FilledHole& hole : report.holes) {
      below[inward] += hole.volume_below;
      above[inward] += hole.volume_above;
    }
    EXPECT_NEAR(below[inward], report.volume_below, 1e-12) << (inward ? "inward" : "outward");
    EXPECT_NEAR(above[inward], report.volume_above, 1e-12) << (inward ? "inward" : "outward");
  }
  EXPECT_GT(std::abs(below[0] - above[0]), 0.1 * below[0]);
}

class TornRocks : public testing::TestWithParam<double> {};

TEST_P(TornRocks, ComeBackToTheLastVertexAndWithTheirVolume) {
  for (std::uint64_t seed = 0; seed < 3; ++seed) {
    SCOPED_TRACE(seed);
    const TriangleMesh rock = rough_rock_mesh(12, {0.5, 0.4, 0.3}, seed, 0.1);
    const FieldBlock block =
        extract_field_blocks(without_triangles(rock, GetParam(), seed), "torn")[0];
    expect_closed_and_sound(block.scan.mesh);
    EXPECT_FALSE(block.underside);
    EXPECT_LT(box_error(block.scan.mesh, rock), 1e-3);
    EXPECT_NEAR(solid_volume(block.scan.mesh) / solid_volume(rock), 1.0, 2e-3);
    const RepairReport& report = block.scan.report;
    EXPECT_NEAR(report.filled_fraction, GetParam(), 0.03);
    EXPECT_LE(solid_volume(rock), solid_volume(block.scan.mesh) + report.volume_above + 1e-12);
    EXPECT_GE(solid_volume(rock), solid_volume(block.scan.mesh) - report.volume_below - 1e-12);
  }
}

INSTANTIATE_TEST_SUITE_P(Shares, TornRocks, testing::Values(0.01, 0.05, 0.1, 0.2, 0.3));

/// Of a few hundred triangles one is a visible share: the range that is reported holds the truth.
TEST(TornSurface, CoarseRocksAreBracketed) {
  for (const int frequency : {2, 4}) {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
      SCOPED_TRACE(std::to_string(frequency) + " " + std::to_string(seed));
      const TriangleMesh rock = rock_mesh(frequency, {0.5, 0.4, 0.3}, seed);
      const FieldBlock block =
          extract_field_blocks(without_triangles(rock, 0.15, seed), "coarse")[0];
      ASSERT_FALSE(block.underside);
      const RepairReport& report = block.scan.report;
      EXPECT_LE(solid_volume(rock), solid_volume(block.scan.mesh) + report.volume_above + 1e-12);
      EXPECT_GE(solid_volume(rock), solid_volume(block.scan.mesh) - report.volume_below - 1e-12);
      EXPECT_LT(box_error(block.scan.mesh, rock), 1e-9);
    }
  }
}

TEST(TornSurface, MissingVerticesAreFilledAsTheirSurroundingsSay) {
  for (const double share : {0.02, 0.06}) {
    const TriangleMesh rock = rock_mesh(16, {0.5, 0.4, 0.3}, 4);
    const FieldBlock block = extract_field_blocks(without_vertices(rock, share, 9), "torn")[0];
    expect_closed_and_sound(block.scan.mesh);
    EXPECT_FALSE(block.underside);
    EXPECT_LT(box_error(block.scan.mesh, rock), 0.005);
    EXPECT_NEAR(solid_volume(block.scan.mesh) / solid_volume(rock), 1.0, 2e-3);
  }
}

/// An unseen side stays one in a torn scan, with its bracket.
TEST(TornSurface, ATornBlockOnTheGroundKeepsItsUnseenSide) {
  std::size_t checked = 0;
  for (const CutBlock& cut : cut_blocks(rock_mesh(14, {0.5, 0.4, 0.3}, 2), 4, 5)) {
    if (cut.seen > 0.97) continue;
    const FieldBlock whole = extract_field_blocks(cut.open, "cut")[0];
    const FieldBlock torn = extract_field_blocks(without_triangles(cut.open, 0.1, 3), "torn")[0];
    ASSERT_TRUE(whole.underside && torn.underside);
    EXPECT_NEAR(torn.underside->lower_volume / whole.underside->lower_volume, 1.0, 0.01);
    EXPECT_NEAR(torn.underside->upper_volume.value() / whole.underside->upper_volume.value(), 1.0,
                0.03);
    ++checked;
  }
  EXPECT_GE(checked, 2u);
}

TEST(TornSurface, AnUnseenSideIsLargeAndWide) {
  const auto round_border = [](int corners, double radius) {
    std::vector<Vec3> border;
    for (int i = 0; i < corners; ++i) {
      const double turn = 2.0 * kPi * i / corners;
      border.emplace_back(radius * std::cos(turn), radius * std::sin(turn), 0.0);
    }
    return border;
  };
  const auto seen_area = [](double radius, double share) {
    return kPi * radius * radius * (1.0 / share - 1.0);
  };
  EXPECT_TRUE(reconstruct_detail::is_unobserved_side(round_border(60, 1.0), seen_area(1.0, 0.02)));
  EXPECT_FALSE(
      reconstruct_detail::is_unobserved_side(round_border(60, 1.0), seen_area(1.0, 0.005)));
  // 12 sides round: two triangles wide.
  EXPECT_FALSE(reconstruct_detail::is_unobserved_side(round_border(12, 1.0), seen_area(1.0, 0.02)));
  EXPECT_TRUE(reconstruct_detail::is_unobserved_side(round_border(12, 1.0), seen_area(1.0, 0.06)));
}

}  // namespace
}  // namespace clast
