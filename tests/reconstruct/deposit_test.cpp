#include "reconstruct/deposit/deposit.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "core/random.hpp"
#include "mesh/geodesic_sphere.hpp"
#include "reconstruct/deposit/detail/prior_ellipsoid.hpp"
#include "reconstruct/deposit/detail/region_classes.hpp"
#include "reconstruct/deposit/detail/star_body.hpp"
#include "shapes/oriented_box.hpp"
#include "tests/support/balls_on_floor.hpp"
#include "tests/support/refusal.hpp"

namespace clast {
namespace {

using namespace reconstruct_detail;

double volume(const FloorBall& ball) { return 4.0 / 3.0 * kPi * std::pow(ball.radius, 3); }

const std::vector<FloorBall> kHeap = {{{-0.5, 0.0, 0.48}, 0.5},
                                      {{0.42, 0.0, 0.40}, 0.42},
                                      {{0.0, 0.62, 0.3}, 0.3},
                                      {{1.6, -0.8, 0.33}, 0.35}};

TEST(Deposit, BallsThatTouchAreBlocksOfTheirOwn) {
  const Deposit deposit = segment_deposit(balls_on_floor(kHeap, 2.5, 0.03, 1));
  ASSERT_EQ(deposit.blocks.size(), kHeap.size());
  const std::size_t order[] = {0, 2, 1, 3};  // by x
  for (std::size_t k = 0; k < kHeap.size(); ++k) {
    const FloorBall& ball = kHeap[order[k]];
    const DepositBlock& block = deposit.blocks[k];
    const Vec3 sides = smallest_box(block.body.vertices).lengths;
    EXPECT_NEAR(sides[0], 2.0 * ball.radius, 0.06 * ball.radius) << k;
    EXPECT_NEAR(signed_volume(block.body), volume(ball), 0.1 * volume(ball)) << k;
    EXPECT_LT((block.centre - ball.centre).norm(), 0.1 * ball.radius) << k;
    EXPECT_NEAR(block.visible_fraction, 0.75, 0.15) << k;
    EXPECT_LT(block.bounds.intervals->lower_volume, volume(ball));
    EXPECT_GT(block.bounds.intervals->upper_volume, volume(ball));
  }
  EXPECT_EQ(deposit.blocks[0].contacts.size(), 2u);
  EXPECT_TRUE(deposit.blocks[3].contacts.empty());
  EXPECT_NEAR(deposit.spacing, 0.03, 0.005);
}

TEST(Deposit, EveryPointBelongsToABlockOrTheGround) {
  const std::vector<Vec3> points = balls_on_floor(kHeap, 2.0, 0.03, 2);
  const Deposit deposit = segment_deposit(points);
  std::vector<int> uses(points.size(), 0);
  std::size_t unused = 0, high = 0;
  for (const std::uint32_t i : deposit.ground) {
    ++uses[i];
    high += points[i].z() > 0.12;
  }
  EXPECT_LT(high, points.size() / 40);  // crevices where balls touch
  for (const DepositBlock& block : deposit.blocks) {
    for (const std::uint32_t i : block.points) ++uses[i];
  }
  for (const int count : uses) {
    EXPECT_LE(count, 1);
    unused += count == 0;
  }
  for (const LeftOutPart& part : deposit.left_out) unused -= part.points;
  EXPECT_EQ(unused, 0u);
}

TEST(Deposit, ThreadsDoNotChangeIt) {
  const std::vector<Vec3> points = balls_on_floor(kHeap, 2.0, 0.03, 3);
  const Deposit one = segment_deposit(points, {.threads = 1});
  const Deposit two = segment_deposit(points, {.threads = 2});
  ASSERT_EQ(one.blocks.size(), two.blocks.size());
  EXPECT_EQ(one.ground, two.ground);
  for (std::size_t k = 0; k < one.blocks.size(); ++k) {
    EXPECT_EQ(one.blocks[k].points, two.blocks[k].points);
    EXPECT_EQ(one.blocks[k].body.vertices, two.blocks[k].body.vertices);
  }
}

TEST(Deposit, TilesDoNotChangeTheBlocks) {
  std::vector<FloorBall> balls;
  for (const double x : {-1.7, 1.5}) {
    for (const FloorBall& ball : kHeap)
      balls.push_back({ball.centre + Vec3(x, 0.7, 0.0), ball.radius});
  }
  const std::vector<Vec3> points = balls_on_floor(balls, 3.6, 0.04, 8);
  const Deposit whole = segment_deposit(points);
  const Deposit tiled = segment_deposit(points, {.tile_points = points.size() / 3});
  ASSERT_EQ(whole.blocks.size(), balls.size());
  ASSERT_EQ(tiled.blocks.size(), balls.size());
  for (std::size_t k = 0; k < balls.size(); ++k) {
    const DepositBlock &a = whole.blocks[k], &b = tiled.blocks[k];
    std::vector<std::uint32_t> common;
    std::set_intersection(a.points.begin(), a.points.end(), b.points.begin(), b.points.end(),
                          std::back_inserter(common));
    EXPECT_GT(common.size(),
              0.98 * static_cast<double>(std::max(a.points.size(), b.points.size())));
    EXPECT_NEAR(signed_volume(b.body), signed_volume(a.body), 0.02 * signed_volume(a.body)) << k;
    EXPECT_EQ(a.contacts, b.contacts) << k;
  }
}

/// Highest place of a ball.
Vec3 top_of(const FloorBall& ball) { return ball.centre + ball.radius * Vec3::UnitZ(); }

TEST(Deposit, EditsCorrectItsBlocks) {
  const std::vector<Vec3> points = balls_on_floor(kHeap, 2.5, 0.03, 1);
  const Deposit before = segment_deposit(points);
  const std::vector<DepositEdit> edits = {
      {DepositEditKind::kAccept, {top_of(kHeap[3])}},
      {DepositEditKind::kMerge, {top_of(kHeap[1]), top_of(kHeap[2])}},
      {DepositEditKind::kCut, {top_of(kHeap[0])}, {{-0.5, -1.0, 0.0}, {-0.5, 1.0, 0.0}}}};
  const Deposit after = segment_deposit(points, {.edits = edits});
  ASSERT_EQ(after.blocks.size(), 4u);  // two sides of 0, 1 with 2, and 3
  const DepositBlock &west = after.blocks[0], &east = after.blocks[1], &merged = after.blocks[2];
  EXPECT_EQ(west.points.size() + east.points.size(), before.blocks[0].points.size());
  EXPECT_EQ(merged.points.size(), before.blocks[1].points.size() + before.blocks[2].points.size());
  for (const std::uint32_t i : west.points) EXPECT_LT(points[i].x(), -0.5 + 1e-9);
  for (const std::uint32_t i : east.points) EXPECT_GT(points[i].x(), -0.5 - 1e-9);
  // The accepted block is as it was, and certain.
  EXPECT_EQ(after.blocks[3].points, before.blocks[3].points);
  EXPECT_EQ(after.blocks[3].body.vertices, before.blocks[3].body.vertices);
  EXPECT_LT(before.blocks[3].confidence, 1.0);
  EXPECT_EQ(after.blocks[3].confidence, 1.0);
  // The order of edits of different blocks and the number of threads do not matter.
  const Deposit again =
      segment_deposit(points, {.edits = {edits[2], edits[0], edits[1]}, .threads = 2});
  ASSERT_EQ(again.blocks.size(), after.blocks.size());
  for (std::size_t k = 0; k < after.blocks.size(); ++k) {
    EXPECT_EQ(again.blocks[k].points, after.blocks[k].points);
    EXPECT_EQ(again.blocks[k].body.vertices, after.blocks[k].body.vertices);
    EXPECT_EQ(again.blocks[k].confidence, after.blocks[k].confidence);
  }
}

TEST(Deposit, EditsOfTilesAreThoseOfTheWhole) {
  std::vector<FloorBall> balls;
  for (int i = 0; i < 6; ++i) balls.push_back({{1.5 * i, 0.2 * (i % 3), 0.38}, 0.4});
  const std::vector<Vec3> points = balls_on_floor(balls, 9.0, 0.05, 8);
  const std::vector<DepositEdit> edits = {{DepositEditKind::kDrop, {top_of(balls[0])}},
                                          {DepositEditKind::kAccept, {top_of(balls[5])}}};
  const std::size_t tile_points = points.size() / 3;
  const Deposit tiled = segment_deposit(points, {.edits = edits, .tile_points = tile_points});
  ASSERT_EQ(tiled.blocks.size(), 5u);
  EXPECT_NEAR(tiled.blocks[0].centre.x(), 1.5, 0.05);
  EXPECT_LT(tiled.blocks[0].confidence, 1.0);
  EXPECT_EQ(tiled.blocks[4].confidence, 1.0);
  const std::vector<DepositEdit> misfit = {edits[0], {DepositEditKind::kDrop, {{0.0, 0.0, 5.0}}}};
  EXPECT_TRUE(contains(
      refusal([&] { segment_deposit(points, {.edits = misfit, .tile_points = tile_points}); }),
      "edit 2 of 2 (drop at (0, 0, 5)): no point of the scan is within"));
}

TEST(Deposit, AcceptanceOfAPartThatIsLeftOutIsRefused) {
  const std::vector<Vec3> points = balls_on_floor(kHeap, 2.0, 0.03, 6);
  const DepositEdit accept{DepositEditKind::kAccept, {top_of(kHeap[2])}};
  EXPECT_TRUE(contains(
      refusal([&] { segment_deposit(points, {.smallest_axis = 0.65, .edits = {accept}}); }),
      "edit 1 of 1 (accept at (0, 0.62, 0.6)): the block is left out (axis I less than"));
}

TEST(Deposit, TheGroundLeftAroundABlockDoesNotChangeIt) {
  const std::vector<FloorBall> one = {{{0.0, 0.0, 0.4}, 0.5}};
  const std::vector<Vec3> wide = balls_on_floor(one, 3.0, 0.03, 4);
  const auto sides_within = [&](double half_width) {
    std::vector<Vec3> cropped;
    for (const Vec3& p : wide) {
      if (p.head<2>().cwiseAbs().maxCoeff() < half_width) cropped.push_back(p);
    }
    const Deposit deposit = segment_deposit(cropped);
    EXPECT_EQ(deposit.blocks.size(), 1u) << half_width;
    return Vec3(smallest_box(deposit.blocks.at(0).body.vertices).lengths);
  };
  const Vec3 sides = sides_within(3.0);
  for (const double half_width : {0.7, 1.0, 1.5, 2.0}) {
    const Vec3 cropped = sides_within(half_width);
    EXPECT_NEAR(cropped[0], sides[0], 0.02 * sides[0]) << half_width;
    EXPECT_NEAR(cropped[1], sides[1], 0.02 * sides[1]) << half_width;
  }
}

TEST(Deposit, TheSameAtAnotherScaleAndPlace) {
  const std::vector<Vec3> points = balls_on_floor(kHeap, 2.0, 0.03, 5);
  std::vector<Vec3> elsewhere;
  for (const Vec3& p : points) elsewhere.push_back(8.0 * p + Vec3(4096.0, -8192.0, 512.0));
  const Deposit here = segment_deposit(points), there = segment_deposit(elsewhere);
  ASSERT_EQ(here.blocks.size(), there.blocks.size());
  for (std::size_t k = 0; k < here.blocks.size(); ++k) {
    EXPECT_NEAR(signed_volume(there.blocks[k].body), 512.0 * signed_volume(here.blocks[k].body),
                0.02 * 512.0 * signed_volume(here.blocks[k].body));
  }
}

TEST(Deposit, BlocksBelowTheSmallestAxisAreListed) {
  const Deposit deposit =
      segment_deposit(balls_on_floor(kHeap, 2.0, 0.03, 6), {.smallest_axis = 0.65});
  EXPECT_EQ(deposit.blocks.size(), 3u);
  ASSERT_EQ(deposit.left_out.size(), 1u);
  EXPECT_EQ(deposit.left_out[0].reason, LeftOutReason::kTooSmall);
  EXPECT_NEAR(deposit.left_out[0].centre.y(), 0.62, 0.1);
}

TEST(Deposit, BlocksWithUncertainOutlinesAreListed) {
  Random random(1);
  std::vector<FloorBall> balls;
  for (int i = 0; i < 40; ++i) {
    const double radius = random.uniform(0.15, 0.4);
    const double x = random.uniform(-2.0, 2.0), y = random.uniform(-2.0, 2.0);
    balls.push_back({{x, y, radius * random.uniform(-0.2, 0.9)}, radius});
  }
  const Deposit deposit = segment_deposit(balls_on_floor(balls, 2.6, 0.07, 1));
  const auto uncertain = std::count_if(
      deposit.left_out.begin(), deposit.left_out.end(),
      [](const LeftOutPart& part) { return part.reason == LeftOutReason::kUncertain; });
  EXPECT_GT(uncertain, 0);
  for (const DepositBlock& block : deposit.blocks) EXPECT_GE(block.confidence, 0.25);
  EXPECT_EQ(name_of(LeftOutReason::kUncertain), "uncertain outline");
}

TEST(Deposit, BlocksCutByTheBorderOfTheScanAreListed) {
  const std::vector<FloorBall> balls = {{{0.0, 0.0, 0.4}, 0.5}, {{2.0, 0.5, 0.45}, 0.5}};
  const std::vector<Vec3> whole = balls_on_floor(balls, 3.5, 0.03, 9);
  // Cuts at distances of 0.3 and 0.1 radii from the centre, and along the flank.
  for (const auto& [limit, is_cut] : {std::pair(2.15, true), {1.95, true}, {2.55, false}}) {
    std::vector<Vec3> cropped;
    for (const Vec3& p : whole) {
      if (p.x() < limit) cropped.push_back(p);
    }
    const Deposit deposit = segment_deposit(cropped);
    EXPECT_EQ(deposit.blocks.size(), is_cut ? 1u : 2u) << limit;
    ASSERT_EQ(deposit.left_out.size(), is_cut ? 1u : 0u) << limit;
    if (is_cut) {
      EXPECT_EQ(deposit.left_out[0].reason, LeftOutReason::kCutByBorder);
      EXPECT_NEAR(deposit.left_out[0].centre.y(), 0.5, 0.1);
    }
  }
}

TEST(Deposit, ABlockWithoutGroundIsNotCutByTheBorder) {
  std::vector<Vec3> alone;
  for (const Vec3& p : balls_on_floor({{{0.0, 0.0, 0.4}, 0.5}}, 2.0, 0.03, 10)) {
    if (p.z() > 0.1) alone.push_back(p);
  }
  EXPECT_EQ(segment_deposit(alone).blocks.size(), 1u);
}

TEST(Deposit, GroundThatABlockEnclosesIsPartOfIt) {
  std::vector<Vec3> plane;
  for (int x = 0; x < 40; ++x) {
    for (int y = 0; y < 40; ++y) plane.emplace_back(x, y, 0.0);
  }
  const OrientedPoints cloud = orient_points(plane, Vec3::Zero(), 1);
  // Blocks in the left and the right half, with a pocket in the left one and one between them.
  std::vector<std::uint32_t> labels, filled;
  for (const Vec3& p : plane) {
    const bool is_pocket = (p - Vec3(8.0, 20.0, 0.0)).norm() < 1.5;
    const bool is_between = (p - Vec3(20.0, 20.0, 0.0)).norm() < 1.5;
    labels.push_back(is_pocket || is_between ? 0 : p.x() < 20.0 ? 1 : 2);
    filled.push_back(is_between ? 0 : p.x() < 20.0 ? 1 : 2);
  }
  fill_enclosed_ground(cloud, labels);
  EXPECT_EQ(labels, filled);
}

TEST(Deposit, BareGroundHasNoBlocks) {
  EXPECT_TRUE(segment_deposit(balls_on_floor({}, 1.5, 0.03, 7)).blocks.empty());
}

TEST(Deposit, TooFewPointsAreRefused) {
  const std::vector<Vec3> few(99, Vec3::Zero());
  EXPECT_TRUE(contains(refusal<GeometryError>([&] { segment_deposit(few); }),
                       "99 points are too few for a deposit"));
  EXPECT_TRUE(contains(refusal([&] { segment_deposit(few, {.smallest_axis = -1.0}); }),
                       "smallest_axis = -1"));
}

/// Samples of a sphere about the origin in the directions with n.z above a limit.
std::vector<SurfaceSample> sphere_samples(double radius, double lowest) {
  std::vector<SurfaceSample> samples;
  for (const Vec3& n : geodesic_sphere(8).vertices) {
    if (n.z() > lowest) samples.push_back({radius * n, n});
  }
  return samples;
}

TEST(VisibilityDefect, IsZeroOnAConvexBodyAndFullInACrevice) {
  const std::vector<SurfaceSample> ball = sphere_samples(1.0, -2.0);
  EXPECT_EQ(visibility_defect(ball, ball, 0.1), 0.0);
  // Two walls that face each other.
  const std::vector<SurfaceSample> left = {{{0, 0, 0}, {1, 0, 0}}},
                                   right = {{{1, 0, 0}, {-1, 0, 0}}};
  EXPECT_EQ(visibility_defect(left, right, 0.1), 1.0);
  EXPECT_EQ(visibility_defect(left, right, 2.0), 0.0);  // no pair is far enough
}

TEST(PriorEllipsoid, OfAWholeSurfaceIsThatSurface) {
  const Vec3 half(0.5, 0.4, 0.3), centre(3.0, -2.0, 1.0);
  std::vector<SurfaceSample> samples;
  for (const Vec3& u : geodesic_sphere(6).vertices) {
    samples.push_back({centre + u.cwiseProduct(half), u.cwiseQuotient(half).normalized()});
  }
  const Ellipsoid found = fit_prior_ellipsoid(samples, {});
  EXPECT_LT((found.centre - centre).norm(), 1e-3);
  EXPECT_NEAR(found.volume(), 4.0 / 3.0 * kPi * half.prod(), 0.01 * found.volume());
}

TEST(PriorEllipsoid, OfAHalfSphereIsNearlyTheSphere) {
  const Ellipsoid found = fit_prior_ellipsoid(sphere_samples(1.0, 0.0), {});
  EXPECT_LT(found.centre.norm(), 0.15);
  EXPECT_NEAR(found.volume(), 4.0 / 3.0 * kPi, 0.2 * found.volume());
}

TEST(StarBody, OfAWholeSphereHasItsVolume) {
  const Ellipsoid unit;
  const StarBody body = fit_star_body(sphere_samples(1.0, -2.0), unit, 0.12);
  EXPECT_NEAR(signed_volume(body.mesh), 4.0 / 3.0 * kPi, 0.08);
  EXPECT_NEAR(body.visible_fraction, 1.0, 1e-12);
  const StarBody half = fit_star_body(sphere_samples(1.0, 0.0), unit, 0.12);
  EXPECT_GT(half.visible_fraction, 0.5);
  EXPECT_LT(half.visible_fraction, 0.7);
}

TEST(StarBody, TheUnobservedSideLeavesFreeSpace) {
  const std::vector<SurfaceSample> upper = sphere_samples(1.0, 0.0);
  const auto below = [](const Vec3& position) { return position.z() < -0.5; };
  const StarBody body = fit_star_body(upper, Ellipsoid{}, 0.12, below);
  double lowest = 0.0;
  for (const Vec3& v : body.mesh.vertices) lowest = std::min(lowest, v.z());
  EXPECT_GE(lowest, -0.5);
  EXPECT_LT(lowest, -0.47);  // not farther than needed
}

}  // namespace
}  // namespace clast
