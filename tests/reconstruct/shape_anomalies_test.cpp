// Closed bodies that are not one rock, and rocks that are.
#include "reconstruct/detail/shape_anomalies.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/number_text.hpp"
#include "core/random.hpp"
#include "reconstruct/detail/body_seam.hpp"
#include "samples/rock_shapes.hpp"
#include "tests/support/odd_bodies.hpp"
#include "tests/support/rock_mesh.hpp"

namespace clast::reconstruct_detail {
namespace {

using DoubtKind = ShapeAnomaly::Kind;

std::vector<DoubtKind> doubt_kinds(const TriangleMesh& closed) {
  std::vector<DoubtKind> kinds;
  for (const ShapeAnomaly& anomaly : find_shape_anomalies(closed)) kinds.push_back(anomaly.kind);
  return kinds;
}

bool has_doubt(const TriangleMesh& closed, DoubtKind kind) {
  const std::vector<DoubtKind> kinds = doubt_kinds(closed);
  return std::find(kinds.begin(), kinds.end(), kind) != kinds.end();
}

TriangleMesh turned_at_random(TriangleMesh mesh, Random& random) {
  return transformed(std::move(mesh), {Vec3(3.0, -2.0, 1.0), random.rotation()});
}

std::string notes_on(const TriangleMesh& closed) {
  std::string notes;
  for (const ShapeAnomaly& anomaly : find_shape_anomalies(closed)) {
    notes += format_shape_anomaly(anomaly, [](const Vec3& p) { return format_point(p); }) + "\n";
  }
  return notes;
}

TEST(DoubtfulForm, ASurfaceThatWasGivenAThicknessIsAShell) {
  Random random(1);
  for (const double cut : {-0.9, -0.7, -0.3, 0.2}) {
    for (const double thickness : {0.01, 0.03, 0.06}) {
      const TriangleMesh shell = turned_at_random(cup(cut, thickness), random);
      ASSERT_GT(signed_volume(shell), 0.0);
      const std::vector<ShapeAnomaly> anomalies = find_shape_anomalies(shell);
      ASSERT_EQ(anomalies.size(), 1u) << cut << ", " << thickness;
      EXPECT_EQ(anomalies[0].kind, DoubtKind::kShell);
      EXPECT_NEAR(anomalies[0].size / thickness, 1.0, 0.1) << cut << ", " << thickness;
    }
  }
}

TEST(DoubtfulForm, BallsThatTouchOrAreJoinedMeetInASeam) {
  Random random(2);
  for (const double second : {0.5, 0.75, 1.0}) {
    for (const double overlap : {0.0, 0.05, 0.15}) {
      const double distance = 1.0 + second * (1.0 - overlap);
      const Pose turn{Vec3(3.0, -2.0, 1.0), random.rotation()};
      const TriangleMesh body = transformed(two_balls(second, distance, 0.1), turn);
      const auto seam = find_body_seam(body);
      ASSERT_TRUE(seam) << second << ", " << overlap;
      // The circle in which two balls cut each other, or the neck.
      const double x = (distance * distance + 1.0 - second * second) / (2.0 * distance);
      const double radius = std::max(0.1, std::sqrt(std::max(0.0, 1.0 - x * x)));
      EXPECT_NEAR((seam->position - turn * Vec3(x, 0.0, 0.0)).norm(), 0.0, 0.15) << second;
      EXPECT_NEAR(seam->width, std::sqrt(kPi) * radius, 0.15) << second << ", " << overlap;
    }
  }
  for (const double gap : {0.05, 0.3}) {
    EXPECT_TRUE(has_doubt(two_balls(0.8, 1.8 + gap, 0.08), DoubtKind::kSeam)) << gap;
  }
}

TEST(DoubtfulForm, ASmallBallOnALargerOneIsFoundOnItsSide) {
  Random random(5);
  for (const double second : {0.2, 0.3, 0.4}) {
    const Pose turn{Vec3(3.0, -2.0, 1.0), random.rotation()};
    const TriangleMesh body = transformed(two_balls(second, 1.0 + 0.95 * second, 0.0), turn);
    const auto seam = find_body_seam(body);
    ASSERT_TRUE(seam) << second;
    const double cubed = second * second * second;
    EXPECT_NEAR(seam->smaller_fraction, cubed / (1.0 + cubed), 0.1 * cubed) << second;
    EXPECT_GT(seam->plane.signed_distance(turn * Vec3(1.0 + second, 0.0, 0.0)), 0.0) << second;
    EXPECT_LT(seam->plane.signed_distance(turn * Vec3(0.5, 0.0, 0.0)), 0.0) << second;
    EXPECT_NEAR(seam->plane.signed_distance(seam->position), 0.0, 1e-9) << second;
  }
}

TEST(DoubtfulForm, BodiesThatTouchInTwoPlacesMeetInASeam) {
  // A notched ball beside another: the plane between them cuts two separate outlines.
  TriangleMesh body = two_balls(0.8, 1.75, 0.3);
  for (Vec3& vertex : body.vertices) {
    const double beside = (vertex.x() - 0.98) / 0.25;
    const double depth = 0.9 * std::exp(-beside * beside);
    if (std::abs(vertex.y()) < 0.15) vertex.z() *= 1.0 - depth;
  }
  EXPECT_TRUE(find_body_seam(body));
}

TEST(DoubtfulForm, AClosedScanOfABlockWithItsGroundIsASlab) {
  Random random(3);
  for (const double rock : {0.3, 0.5, 0.8}) {
    for (const double depth : {0.02, 0.1, 0.4}) {
      for (const double rough : {0.0, 0.005}) {
        const TriangleMesh body = turned_at_random(slab(3.0, depth, rock, rough, 7), random);
        const std::vector<ShapeAnomaly> anomalies = find_shape_anomalies(body);
        ASSERT_FALSE(anomalies.empty()) << rock << ", " << depth << ", " << rough;
        EXPECT_EQ(anomalies[0].kind, DoubtKind::kSlab) << rock << ", " << depth << ", " << rough;
        EXPECT_NEAR(anomalies[0].size, 3.0, 0.3);
      }
    }
  }
}

TEST(DoubtfulForm, ADeepHollowIsReportedWithItsDepth) {
  // A ring: its inside is as deep below the hull as it is thick.
  const TriangleMesh ring = torus_without_inner_wall(0.3, 0.05, 0.0);
  const std::vector<ShapeAnomaly> anomalies = find_shape_anomalies(ring);
  ASSERT_FALSE(anomalies.empty());
  EXPECT_EQ(anomalies[0].kind, DoubtKind::kHollow);
  EXPECT_NEAR(anomalies[0].size, 0.05, 0.005);
  EXPECT_NEAR(anomalies[0].fraction, 0.41, 0.03);
}

TEST(DoubtfulForm, OneRockIsNotDoubted) {
  Random random(4);
  std::size_t rocks = 0;
  for (const RockRecipe& recipe : sample_recipes()) {
    EXPECT_EQ(notes_on(turned_at_random(rock(recipe), random)), "") << recipe.name;
    ++rocks;
  }
  for (const Vec3& half : {Vec3(1.0, 0.9, 0.8), Vec3(1.0, 0.8, 0.1), Vec3(1.0, 0.12, 0.1),
                           Vec3(1.0, 0.4, 0.2), Vec3(1.0, 1.0, 0.25)}) {
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
      const TriangleMesh mesh = turned_at_random(rock_mesh(12, half, seed), random);
      EXPECT_EQ(notes_on(mesh), "") << half.transpose() << ", seed " << seed;
      ++rocks;
    }
  }
  EXPECT_GE(rocks, 35u);
}

}  // namespace
}  // namespace clast::reconstruct_detail
