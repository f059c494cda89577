#include "particles/ball_union.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/error.hpp"
#include "core/random.hpp"

namespace clast {
namespace {

const double kUnitVolume = 4.0 / 3.0 * kPi;

double union_volume(const std::vector<Ball>& balls) {
  return ball_union_mass_properties(balls, 1.0).volume;
}

std::vector<Ball> random_balls(Random& random, std::size_t count) {
  std::vector<Ball> balls;
  for (std::size_t i = 0; i < count; ++i) {
    const double x = random.uniform(-1.0, 1.0), y = random.uniform(-1.0, 1.0);
    balls.push_back({{x, y, random.uniform(-1.0, 1.0)}, random.uniform(0.1, 0.8)});
  }
  return balls;
}

/// Volume, first and second moments by one random point in each cell of a grid.
struct SampledMoments {
  double volume = 0.0;
  Vec3 first = Vec3::Zero();
  Mat3 second = Mat3::Zero();
};

SampledMoments sample_moments(const std::vector<Ball>& balls, int cells, Random& random) {
  constexpr double kHalf = 1.8;
  const double step = 2.0 * kHalf / cells, cell = step * step * step;
  SampledMoments sum;
  for (int i = 0; i < cells * cells * cells; ++i) {
    const Vec3 corner(i % cells, i / cells % cells, i / cells / cells);
    const Vec3 inside(random.uniform(), random.uniform(), random.uniform());
    const Vec3 point = step * (corner + inside) - Vec3::Constant(kHalf);
    for (const Ball& ball : balls) {
      if ((point - ball.centre).squaredNorm() > ball.radius * ball.radius) continue;
      sum.volume += cell;
      sum.first += cell * point;
      sum.second += cell * point * point.transpose();
      break;
    }
  }
  return sum;
}

TEST(BallUnion, OneBallHasItsVolumeCentreAndInertia) {
  const MassProperties ball = ball_union_mass_properties({{{{5.0, 6.0, 7.0}, 2.0}}}, 3.0);
  EXPECT_NEAR(ball.volume, 8.0 * kUnitVolume, 1e-9);
  EXPECT_NEAR(ball.mass, 24.0 * kUnitVolume, 1e-8);
  EXPECT_LT((ball.centre - Vec3(5.0, 6.0, 7.0)).norm(), 1e-12);
  EXPECT_LT((ball.inertia - 0.4 * ball.mass * 4.0 * Mat3::Identity()).norm(), 1e-8);
}

TEST(BallUnion, VolumeOfTwoBallsIsTheClosedForm) {
  const double R = 1.0, r = 0.7;
  for (const double d : {0.31, 0.5, 1.0, 1.2, 1.69}) {
    const double lens = kPi * std::pow(R + r - d, 2.0) *
                        (d * d + 2.0 * d * (R + r) - 3.0 * (R - r) * (R - r)) / (12.0 * d);
    EXPECT_NEAR(union_volume({{{0, 0, 0}, R}, {{0, d, 0}, r}}),
                kUnitVolume * (1.0 + r * r * r) - lens, 1e-9)
        << d;
  }
}

TEST(BallUnion, CentreAndInertiaOfTwoBallsAreThoseOfTwoCaps) {
  // Two unit balls at distance 2h are two balls cut at h: integrals of discs along the axis.
  const double h = 0.4, from = -h, to = 1.0;
  double volume = 0.0, along = 0.0, across = 0.0;
  const int steps = 100000;
  for (int i = 0; i < steps; ++i) {
    const double x = from + (i + 0.5) * (to - from) / steps, disc = 1.0 - x * x;
    const double slice = kPi * disc * (to - from) / steps;
    volume += 2.0 * slice;
    along += 2.0 * slice * (x + h) * (x + h);
    across += 2.0 * slice * disc / 4.0;
  }
  const MassProperties both =
      ball_union_mass_properties({{{{-h, 0, 0}, 1.0}, {{h, 0, 0}, 1.0}}}, 1);
  EXPECT_NEAR(both.volume, volume, 1e-8);
  EXPECT_LT(both.centre.norm(), 1e-10);
  EXPECT_NEAR(both.inertia(0, 0), 2.0 * across, 1e-8);
  EXPECT_NEAR(both.inertia(1, 1), along + across, 1e-8);
  EXPECT_NEAR(both.inertia(0, 1), 0.0, 1e-10);
}

TEST(BallUnion, ContainedEqualTouchingAndDistantBallsAreCountedOnce) {
  const Ball unit = {Vec3::Zero(), 1.0};
  EXPECT_NEAR(union_volume({unit, unit}), kUnitVolume, 1e-9);
  EXPECT_NEAR(union_volume({unit, unit, unit, {{0.2, 0, 0}, 0.3}}), kUnitVolume, 1e-9);
  EXPECT_NEAR(union_volume({unit, {{0.5, 0, 0}, 0.5}}), kUnitVolume, 1e-9);
  EXPECT_NEAR(union_volume({unit, {{2.0, 0, 0}, 1.0}}), 2.0 * kUnitVolume, 1e-9);
  EXPECT_NEAR(union_volume({unit, {{9.0, 0, 0}, 1.0}}), 2.0 * kUnitVolume, 1e-9);
}

TEST(BallUnion, SpheresThroughOneCircleAreThoseOfTheOuterTwo) {
  std::vector<Ball> balls;
  for (int i = -3; i <= 3; ++i) balls.push_back({{0, 0, 0.2 * i}, std::sqrt(1.0 + 0.04 * i * i)});
  EXPECT_NEAR(union_volume(balls), union_volume({balls.front(), balls.back()}), 1e-9);
}

TEST(BallUnion, FourSpheresThroughOnePointChangeLittleWhenMoved) {
  std::vector<Ball> balls;
  for (int i = 0; i < 64; ++i) balls.push_back({Vec3(i % 4, i / 4 % 4, i / 16), std::sqrt(0.5)});
  const double exact = union_volume(balls);
  Random random(3);
  for (Ball& ball : balls) ball.centre += 1e-7 * random.unit_vector();
  EXPECT_NEAR(union_volume(balls), exact, 1e-5);
}

TEST(BallUnion, RandomUnionsAgreeWithSamples) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    Random random(seed);
    std::vector<Ball> balls = random_balls(random, 2 + seed % 12);
    if (seed % 3 == 0) balls.push_back(balls[0]);
    const MassProperties exact = ball_union_mass_properties(balls, 1.0);
    const SampledMoments sampled = sample_moments(balls, 60, random);
    const Mat3 second = 0.5 * exact.inertia.trace() * Mat3::Identity() - exact.inertia +
                        exact.volume * exact.centre * exact.centre.transpose();
    // Five standard deviations: about 8,000 cells of 2e-4 at the surface, each half inside.
    EXPECT_NEAR(sampled.volume, exact.volume, 0.05) << seed;
    EXPECT_LT((sampled.first - exact.volume * exact.centre).norm(), 0.07) << seed;
    EXPECT_LT((sampled.second - second).norm(), 0.1) << seed;
  }
}

TEST(BallUnion, MovesAndTurnsWithItsBalls) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    Random random(seed);
    std::vector<Ball> balls = random_balls(random, 12);
    const MassProperties before = ball_union_mass_properties(balls, 1.0);
    const Mat3 turn = random.rotation().toRotationMatrix();
    const Vec3 shift(10.0, -20.0, 30.0);
    for (Ball& ball : balls) ball.centre = turn * ball.centre + shift;
    const MassProperties after = ball_union_mass_properties(balls, 1.0);
    EXPECT_NEAR(after.volume, before.volume, 1e-9);
    EXPECT_LT((after.centre - turn * before.centre - shift).norm(), 1e-9);
    EXPECT_LT((after.inertia - turn * before.inertia * turn.transpose()).norm(), 1e-8);
  }
}

TEST(BallUnion, ExposedAreasAreTheDerivativeOfTheVolume) {
  Random random(5);
  std::vector<Ball> balls = random_balls(random, 10);
  double sum = 0.0;
  for (const double area : exposed_areas(balls)) sum += area;
  constexpr double kStep = 1e-5;
  std::vector<Ball> larger = balls, smaller = balls;
  for (Ball& ball : larger) ball.radius += kStep;
  for (Ball& ball : smaller) ball.radius -= kStep;
  EXPECT_NEAR((union_volume(larger) - union_volume(smaller)) / (2.0 * kStep), sum, 1e-4);
}

TEST(BallUnion, InvalidBallsAreRefused) {
  EXPECT_THROW(union_volume({}), InputError);
  EXPECT_THROW(union_volume({{Vec3::Zero(), 0.0}}), InputError);
  EXPECT_THROW(union_volume({{Vec3::Constant(NAN), 1.0}}), InputError);
}

}  // namespace
}  // namespace clast
