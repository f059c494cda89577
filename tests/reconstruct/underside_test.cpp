#include "reconstruct/underside/underside.hpp"

#include <gtest/gtest.h>

#include <iostream>

#include "core/error.hpp"
#include "mesh/mesh_topology.hpp"
#include "mesh/self_intersection.hpp"
#include "mesh/sub_mesh.hpp"
#include "reconstruct/repair/components.hpp"
#include "reconstruct/repair/non_manifold_split.hpp"
#include "shapes/oriented_box.hpp"
#include "tests/support/cut_blocks.hpp"
#include "tests/support/odd_bodies.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/rock_mesh.hpp"
#include "tests/support/solid_volume.hpp"

namespace clast {
namespace {

/// A square frustum from z = 0 up to `height`, with sides `bottom` and `top`, open below, on a mesh
/// with `cuts` steps along every edge so that its rim has vertices.
TriangleMesh open_frustum(double bottom, double top, double height, int cuts = 8) {
  TriangleMesh mesh;
  const auto ring = [&](double z) {
    const double half = 0.5 * (bottom + (top - bottom) * z / height);
    const Vec3 corners[4] = {
        {-half, -half, z}, {half, -half, z}, {half, half, z}, {-half, half, z}};
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (int side = 0; side < 4; ++side) {
      for (int k = 0; k < cuts; ++k) {
        mesh.vertices.push_back(corners[side] + k / static_cast<double>(cuts) *
                                                    (corners[(side + 1) % 4] - corners[side]));
      }
    }
    return first;
  };
  const auto around = static_cast<std::uint32_t>(4 * cuts);
  std::uint32_t below = ring(0.0);
  for (int layer = 1; layer <= cuts; ++layer) {
    const std::uint32_t above = ring(height * layer / cuts);
    for (std::uint32_t i = 0; i < around; ++i) {
      const std::uint32_t j = (i + 1) % around;
      mesh.triangles.push_back({below + i, below + j, above + j});
      mesh.triangles.push_back({below + i, above + j, above + i});
    }
    below = above;
  }
  const auto middle = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.vertices.emplace_back(0.0, 0.0, height);
  for (std::uint32_t i = 0; i < around; ++i) {
    mesh.triangles.push_back({middle, below + i, below + (i + 1) % around});
  }
  return mesh;
}

double frustum_volume(double bottom, double top, double height) {
  return height / 3.0 * (bottom * bottom + bottom * top + top * top);
}

// The walls of a pyramid narrow evenly, so the upper shape is the pyramid itself.
TEST(Underside, UpperBoundOfACutPyramidIsTheWholePyramid) {
  const Underside side = *close_underside(open_frustum(0.3, 1.0, 0.8), {.max_depth_fraction = 1.0});
  EXPECT_NEAR(side.lower_volume, frustum_volume(0.3, 1.0, 0.8), 1e-9);
  // Sides grow by 0.7 over 0.8, so the tip lies 0.3 * 0.8 / 0.7 below the rim.
  const double tip = 0.3 * 0.3 * (0.3 * 0.8 / 0.7) / 3.0;
  EXPECT_NEAR(side.upper_volume.value(), side.lower_volume + tip, 5e-3 * tip);
  // The section is read a millionth of the height above the rim.
  EXPECT_NEAR(side.estimated_volume, side.lower_volume + 0.6 * tip, 3e-5 * tip);
}

// Nothing shows how far upright walls go down; the likeliest is a share of the height seen.
TEST(Underside, UprightWallsHaveNoUpperBound) {
  const Underside side = *close_underside(open_frustum(0.5, 0.5, 0.6));
  EXPECT_NEAR(side.lower_volume, 0.5 * 0.5 * 0.6, 1e-9);
  EXPECT_FALSE(side.upper_volume.has_value());
  EXPECT_FALSE(side.sides.has_value());
  EXPECT_NEAR(side.estimated_volume, 0.5 * 0.5 * 0.72, 1e-6);
  EXPECT_LT((side.down + Vec3::UnitZ()).norm(), 1e-9);
  EXPECT_EQ(side.rim_edges, 32u);
  EXPECT_NEAR(side.rim_length, 2.0, 1e-9);
  EXPECT_LT(side.rim_centre.norm(), 1e-9);
}

// The planes of the flanks that close bound a block, whatever the ground is.
TEST(Underside, FlanksThatCloseBoundABlockOnTheGround) {
  const UndersideOptions options{.ground = Plane{Vec3::UnitZ(), -0.05}};
  const Underside side = *close_underside(open_frustum(0.2, 0.6, 0.6), options);
  EXPECT_NEAR(side.ground_clearance, 0.05, 1e-12);
  EXPECT_NEAR(side.upper_volume.value(), 0.6 * 0.6 * 0.9 / 3.0, 1e-3);  // they meet 0.3 m below
  EXPECT_GE(bounds(side.best_estimate).low.z(), -0.08 - 1e-9);
  EXPECT_LT(bounds(side.best_estimate).low.z(), -0.03);
}

// How deep a block goes does not follow from where the points on its flanks end: these go straight
// down, or lean out, to the ground or to somewhere above it.
TEST(Underside, HasNoUpperBoundBelowFlanksThatDoNotClose) {
  for (const double bottom : {0.47, 0.5, 0.7}) {
    for (const double ground : {0.0, -0.01, -0.05, -0.2}) {
      const Underside side = *close_underside(open_frustum(bottom, 0.5, 0.6),
                                              {.ground = Plane{Vec3::UnitZ(), ground}});
      EXPECT_FALSE(side.upper_volume) << bottom << ", ground at " << ground;
      EXPECT_FALSE(side.sides) << bottom << ", ground at " << ground;
      EXPECT_EQ(side.assumption, "");
    }
  }
}

// Of a block that leans most of the rim hangs far above the ground; the end that is in it may be as
// deep as if all of the rim were.
TEST(Underside, ABlockThatLeansHasNoUpperBound) {
  TriangleMesh open = open_frustum(0.5, 0.5, 0.6);
  std::vector<bool> keep;
  for (const auto& [a, b, c] : open.triangles) {
    const Vec3 middle = (open.vertices[a] + open.vertices[b] + open.vertices[c]) / 3.0;
    keep.push_back(middle.z() > 0.15 || middle.x() < -0.2);
  }
  open = extract_triangles(open, keep);
  const Underside side = *close_underside(open, {.ground = Plane{Vec3::UnitZ(), 0.0}});
  EXPECT_GT(side.ground_clearance, 0.05);
  EXPECT_FALSE(side.upper_volume);
}

// A ball that is buried to any depth, of which the lowest points are missing: the range holds it.
TEST(Underside, TheRangeHoldsABallHoweverDeepItIsBuried) {
  const TriangleMesh ball = geodesic_sphere(24);
  const double whole = solid_volume(ball);
  std::size_t bounded = 0;
  for (const double level : {0.3, 0.1, 0.0, -0.2, -0.5, -0.8}) {
    for (const double missing : {0.0, 0.03, 0.08, 0.15}) {
      // Seen above a height of `level + missing`, on a ground at `level`.
      if (level + missing > 0.15) continue;  // less is seen than a sheet
      const Underside side = *close_underside(above_level(ball, level + missing + 1e-4),
                                              {.ground = Plane{Vec3::UnitZ(), level}});
      EXPECT_LE(side.lower_volume, whole) << level << ", " << missing;
      if (!side.upper_volume) continue;
      ++bounded;
      EXPECT_GE(*side.upper_volume, whole) << level << ", " << missing;
      for (const double length : side.sides->upper) EXPECT_GE(length, 2.0 - 1e-3);
    }
  }
  EXPECT_GE(bounded, 4u);
}

// The wall of a tunnel was not seen: what is between its mouths may be empty.
TEST(Underside, ATunnelWhoseWallWasNotSeenLeavesTheLowerBound) {
  for (const double thick : {0.12, 0.15, 0.2}) {
    for (const double unobserved : {40.0, 60.0, 75.0}) {
      const TriangleMesh open = torus_without_inner_wall(0.3, thick, unobserved);
      const std::optional<Underside> side = close_underside(open, {});
      ASSERT_TRUE(side);
      const double whole = 2.0 * kPi * kPi * 0.3 * thick * thick;
      EXPECT_LE(side->lower_volume, 0.99 * whole) << thick << ", " << unobserved;
      EXPECT_GE(side->lower_volume, 0.5 * whole) << thick << ", " << unobserved;
      if (side->upper_volume) {
        EXPECT_GE(*side->upper_volume, 0.99 * whole);
      }
      EXPECT_TRUE(std::any_of(
          side->notes.begin(), side->notes.end(),
          [](const std::string& note) { return contains(note, "a tunnel may connect"); }))
          << thick << ", " << unobserved;
    }
  }
}

// A gap in a face, an edge or a corner is no mouth of a tunnel, whatever is seen across the body.
TEST(Underside, GapsInAConvexSurfaceAreNoTunnels) {
  const TriangleMesh ball = geodesic_sphere(24);
  for (const double width : {0.1, 0.2, 0.5}) {
    std::vector<bool> keep;
    for (const auto& [a, b, c] : ball.triangles) {
      const Vec3 middle = (ball.vertices[a] + ball.vertices[b] + ball.vertices[c]).normalized();
      keep.push_back(std::abs(middle.z()) < std::cos(width));
    }
    const std::optional<Underside> side = close_underside(extract_triangles(ball, keep), {});
    ASSERT_TRUE(side) << width;
    for (const std::string& note : side->notes) EXPECT_FALSE(contains(note, "tunnel")) << note;
  }
}

// Height above the cut 1 + c for a ball of radius 1 with the cut at -c. The cap below is
// pi (1 - c)^2 (2 + c)/3.
TEST(Underside, HoldsTheCapOfABall) {
  const TriangleMesh ball = geodesic_sphere(24);
  const double whole = solid_volume(ball);
  for (const double c : {0.93, 0.81, 0.63}) {
    const Underside side = *close_underside(above_level(ball, -c + 1e-4));
    const double cap = kPi * (1 - c) * (1 - c) * (2 + c) / 3.0;
    EXPECT_NEAR(side.lower_volume, whole - cap, 0.003 * whole) << c;
    // The cone that touches the ball at the rim, whose tip is 1/c from the middle.
    const double cone = kPi * (1 - c * c) * (1 / c - c) / 3.0;
    EXPECT_GT(side.upper_volume.value(), whole - cap + cone) << c;
    // The tangents are those of patches, and some of a patch's width inside the rim.
    EXPECT_LT(side.upper_volume.value(), whole - cap + 2.2 * cone) << c;
    EXPECT_NEAR(side.estimated_volume, whole, 0.02 * whole) << c;
    // A ball's cap of height h has 2 pi h of 4 pi.
    EXPECT_NEAR(side.filled_fraction, 0.5 * (1 - c), 0.02) << c;
  }
}

TEST(Underside, BothShapesAreClosedAndKeepWhatWasSeen) {
  for (const CutBlock& block : cut_blocks(rock_mesh(12, {0.5, 0.4, 0.3}, 4), 3, 11)) {
    const Underside side = *close_underside(block.open);
    for (const TriangleMesh* mesh : {&side.lower_mesh, &side.best_estimate}) {
      const MeshReport report = inspect_mesh(*mesh);
      EXPECT_TRUE(report.is_closed() && report.is_oriented()) << report.summary();
      ASSERT_GE(mesh->vertices.size(), block.open.vertices.size());
      EXPECT_TRUE(std::equal(block.open.vertices.begin(), block.open.vertices.end(),
                             mesh->vertices.begin()));
      EXPECT_TRUE(std::equal(block.open.triangles.begin(), block.open.triangles.end(),
                             mesh->triangles.begin()));
    }
    EXPECT_EQ(side.first_filling, block.open.triangles.size());
    EXPECT_GE(solid_volume(side.lower_mesh), side.lower_volume);
    EXPECT_NEAR(solid_volume(side.best_estimate), side.estimated_volume, 1e-9);
    EXPECT_TRUE(find_self_intersections(side.best_estimate).empty());
    // The smallest box of the seen part, found anew after closing.
    const std::vector<Vec3> seen(side.best_estimate.vertices.begin(),
                                 side.best_estimate.vertices.begin() +
                                     static_cast<std::ptrdiff_t>(block.open.vertices.size()));
    EXPECT_EQ(smallest_box(seen).lengths, smallest_box(block.open.vertices).lengths);
  }
}

TEST(Underside, MovesTurnsAndScalesWithTheBlock) {
  const CutBlock block = cut_blocks(rock_mesh(12, {0.5, 0.4, 0.3}, 5), 1, 3)[0];
  const Underside here = *close_underside(block.open);
  Random random(8);
  const Pose pose{{420000.0, 5200000.0, 800.0}, random.rotation()};
  const Underside there = *close_underside(transformed(scaled(block.open, 3.0), pose));
  EXPECT_NEAR(there.lower_volume / here.lower_volume, 27.0, 1e-6);
  EXPECT_NEAR(there.estimated_volume / here.estimated_volume, 27.0, 1e-5);
  EXPECT_NEAR(there.upper_volume.value() / here.upper_volume.value(), 27.0, 1e-5);
  EXPECT_LT((there.sides->lower - 3.0 * here.sides->lower).norm(), 0.02 * here.sides->lower.norm());
  EXPECT_LT((there.sides->upper - 3.0 * here.sides->upper).norm(), 0.02 * here.sides->upper.norm());
  EXPECT_NEAR(there.filled_fraction, here.filled_fraction, 1e-4);
}

TEST(Underside, SameInputGivesTheSameBits) {
  const CutBlock block = cut_blocks(rock_mesh(12, {0.5, 0.4, 0.3}, 6), 1, 4)[0];
  const Underside first = *close_underside(block.open), second = *close_underside(block.open);
  EXPECT_EQ(first.best_estimate.vertices, second.best_estimate.vertices);
  EXPECT_EQ(first.best_estimate.triangles, second.best_estimate.triangles);
  EXPECT_EQ(first.upper_volume, second.upper_volume);
  EXPECT_EQ(first.sides->lower, second.sides->lower);
  EXPECT_EQ(first.sides->upper, second.sides->upper);
}

TEST(Underside, FewPosesOfThreeRocksAreInsideTheBracket) {
  for (const std::uint64_t seed : {1u, 2u, 3u}) {
    for (const CutBlock& block : cut_blocks(rock_mesh(12, {0.5, 0.4, 0.3}, seed), 3, seed)) {
      const Underside side = *close_underside(block.open);
      EXPECT_LE(side.lower_volume, block.volume) << seed;
      EXPECT_GE(side.upper_volume.value_or(block.volume), block.volume) << seed;
      const double bar = block.seen >= 0.95 ? 0.03 : 0.10;
      EXPECT_NEAR(side.estimated_volume, block.volume, bar * block.volume) << seed;
    }
  }
}

/// The triangles of a body that a camera above the ground sees: what faces down more steeply than
/// `steepest` in the lower half is missing, as under an overhang.
TriangleMesh without_overhangs(const TriangleMesh& body, double steepest) {
  const Bounds box = bounds(body);
  const double middle = 0.5 * (box.low.z() + box.high.z());
  std::vector<bool> keep(body.triangles.size(), true);
  for (std::size_t t = 0; t < keep.size(); ++t) {
    const auto& [a, b, c] = body.triangles[t];
    const Vec3 &p = body.vertices[a], &q = body.vertices[b], &r = body.vertices[c];
    const Vec3 normal = (q - p).cross(r - p).normalized();
    keep[t] = normal.z() > -steepest || (p.z() + q.z() + r.z()) / 3.0 > middle;
  }
  TriangleMesh seen =
      reconstruct_detail::connected_components(extract_triangles(body, keep)).front().mesh;
  reconstruct_detail::split_non_manifold_vertices(seen);
  return seen;
}

// Under an overhang the rim is ragged and high, and the sections say little of what is below it:
// the bounds have to be wide enough all the same.
TEST(Underside, UndercutBlocksAreInsideTheBracket) {
  std::size_t count = 0, inside = 0;
  double worst_best = 0.0, worst_miss = 0.0, least_told = 1.0;
  for (const std::uint64_t seed : {1u, 2u, 3u}) {
    const TriangleMesh rock = rock_mesh(14, {0.5, 0.4, 0.3}, seed);
    Random random(seed);
    for (int pose = 0; pose < 10; ++pose) {
      const TriangleMesh body = transformed(rock, Pose{Vec3::Zero(), random.rotation()});
      const TriangleMesh seen = without_overhangs(body, random.uniform(0.3, 0.7));
      const double truth = solid_volume(body);
      const Plane ground{Vec3::UnitZ(), bounds(body).low.z()};
      const Underside side = *close_underside(seen, {.ground = ground});
      if (!side.upper_volume) continue;
      const double below = side.lower_volume / truth - 1.0;
      const double above = 1.0 - *side.upper_volume / truth;
      ++count;
      inside += below <= 0.0 && above <= 0.0;
      worst_miss = std::max({worst_miss, below, above});
      worst_best = std::max(worst_best, std::abs(side.estimated_volume / truth - 1.0));
      const double unobserved = 1.0 - surface_area(seen) / surface_area(body);
      least_told = std::min(least_told, side.filled_fraction / unobserved);
    }
  }
  std::cout << inside << " of " << count << " inside, worst miss " << worst_miss
            << ", best off by up to " << worst_best << ", least invented over unseen " << least_told
            << "\n";
  EXPECT_GE(count, 20u);  // of 30; of the others nothing shows how deep they are buried
  EXPECT_EQ(inside, count);
  EXPECT_LT(worst_best, 0.12);
  // A smooth filling has less area than the rough rock it stands for, but not much less.
  EXPECT_GT(least_told, 0.7);
}

TEST(Underside, OtherHolesAreClosedFlatAndTold) {
  TriangleMesh open = open_frustum(0.5, 0.4, 0.6);
  open.triangles.erase(open.triangles.begin() + 120, open.triangles.begin() + 121);
  const Underside side = *close_underside(open);
  EXPECT_TRUE(inspect_mesh(side.best_estimate).is_closed());
  EXPECT_EQ(side.open_sides, 1u);
  ASSERT_EQ(side.notes.size(), 1u);
  EXPECT_EQ(side.notes[0], "1 other hole filled straight across");
}

TEST(Underside, LargeHolesAreBracketedTogether) {
  TriangleMesh open = open_frustum(0.5, 0.4, 0.6);
  open.triangles.erase(open.triangles.begin() + 120, open.triangles.begin() + 124);
  const Underside side = *close_underside(open);
  EXPECT_TRUE(inspect_mesh(side.best_estimate).is_closed());
  EXPECT_EQ(side.open_sides, 2u);
  EXPECT_TRUE(side.notes.empty());
}

TEST(Underside, AClosedScanHasNone) {
  EXPECT_FALSE(close_underside(rock_mesh(8, {0.5, 0.4, 0.3}, 1)).has_value());
}

TEST(Underside, AHoleTooSmallForAnUndersideIsLeftAlone) {
  TriangleMesh mesh = rock_mesh(16, {0.5, 0.4, 0.3}, 1);
  mesh.triangles.erase(mesh.triangles.begin() + 100, mesh.triangles.begin() + 104);
  EXPECT_FALSE(close_underside(mesh).has_value());
}

TEST(Underside, ASheetIsRefusedWithItsBorder) {
  TriangleMesh sheet;
  for (int j = 0; j < 6; ++j) {
    for (int i = 0; i < 6; ++i) sheet.vertices.emplace_back(i, j, 0.1 * ((i * j) % 3));
  }
  for (std::uint32_t j = 0; j < 5; ++j) {
    for (std::uint32_t i = 0; i < 5; ++i) {
      const std::uint32_t a = 6 * j + i;
      sheet.triangles.push_back({a, a + 1, a + 7});
      sheet.triangles.push_back({a, a + 7, a + 6});
    }
  }
  const std::string message = refusal<GeometryError>([&] { close_underside(sheet); });
  EXPECT_TRUE(contains(message,
                       "the largest component is the ground, or one side of a block: a sheet whose "
                       "border of 20 edges near"))
      << message;
}

TEST(Underside, ASurfaceThatIsNoSimpleSheetIsRefused) {
  TriangleMesh mesh = open_frustum(0.5, 0.4, 0.6);
  mesh.triangles.push_back({0, 1, 40});
  const std::string message = refusal<GeometryError>([&] { close_underside(mesh); });
  EXPECT_TRUE(contains(message, "not a simple sheet")) << message;
}

TEST(Underside, ASurfaceThatFacesInwardsIsRefused) {
  TriangleMesh mesh = open_frustum(0.5, 0.4, 0.6);
  for (TriangleMesh::Triangle& t : mesh.triangles) std::swap(t[1], t[2]);
  const std::string message = refusal<GeometryError>([&] { close_underside(mesh); });
  EXPECT_TRUE(contains(message, "turn its faces outward")) << message;
}

TEST(Underside, OptionsOutOfRangeAreNamed) {
  const TriangleMesh mesh = open_frustum(0.5, 0.4, 0.6);
  EXPECT_TRUE(contains(refusal([&] { close_underside(mesh, {.max_depth_fraction = -1.0}); }),
                       "max_depth_fraction"));
  EXPECT_TRUE(contains(refusal([&] {
                         close_underside(mesh, {.ground = Plane{Vec3(0.0, 0.0, 2.0), 0.0}});
                       }),
                       "ground normal"));
  EXPECT_TRUE(contains(refusal([&] {
                         close_underside(mesh,
                                         {.min_hole_fraction = 0.5, .max_filling_fraction = 0.4});
                       }),
                       "smallest_share"));
}

}  // namespace
}  // namespace clast
