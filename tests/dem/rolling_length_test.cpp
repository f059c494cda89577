// Rolling resistance that winds up over a length of the ground.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/error.hpp"
#include "dem/contact/stiffness.hpp"
#include "tests/support/gravity.hpp"
#include "tests/support/test_bodies.hpp"

namespace clast {
namespace {

constexpr double kRollingRadius = 0.3, kRollingMass = 100.0;

/// Flat ground, all of zone 1.
TerrainSurface second_zone() {
  TriangleMesh mesh = plane_mesh(20.0, 4);
  std::vector<std::uint16_t> zones(mesh.triangles.size(), 1);
  return TerrainSurface(std::move(mesh), std::move(zones));
}

/// A ball that rolls against a spring swings about its contact point: it turns by
/// w (J_c/k_r)^(1/2), J_c = 7/5 m r^2, before it comes back.
TEST(RollingLength, IsTheArmOfTheSpringThatABallRollsAgainst) {
  const TerrainSurface terrain = second_zone();
  const RigidBody body = ball(kRollingMass, kRollingRadius);
  ReleaseSettings settings = stiff_settings(body, 1e7);
  settings.start_overlap = 1.0;
  settings.max_time = 1.0;
  for (const double length : {0.01, 0.02}) {
    RigidState start;
    start.position.z() = kRollingRadius - kRollingMass * kTestGravity / 1e7;
    start.angular_velocity.y() = 1.0;
    start.velocity.x() = kRollingRadius;
    double farthest = 0.0;
    // The length of the first zone, which the ball does not meet, is another.
    const std::vector<GroundParameters> zones{{1.0, 5.0, 50.0, 0.05}, {1.0, 5.0, 50.0, length}};
    simulate_release(terrain, zones, body, start, settings, [&](const MotionStep& step) {
      farthest = std::max(farthest, step.end.position.x());
    });
    const double turn =
        std::sqrt(1.4 * kRollingMass * kRollingRadius * kRollingRadius / (1e7 * length * length));
    EXPECT_NEAR(farthest, kRollingRadius * turn, 0.005 * kRollingRadius * turn) << length << " m";
  }
}

/// Spin with which a ball leaves the ground after an oblique impact, rad/s.
double spin_after_impact(double stiffness, double rolling_stiffness, double length) {
  const TerrainSurface terrain = second_zone();
  const RigidBody body = ball(kRollingMass, kRollingRadius);
  ReleaseSettings settings = stiff_settings(body, stiffness);
  settings.stiffness.rolling = rolling_stiffness;
  settings.gravity = 1e-2;
  settings.max_time = 0.3;
  RigidState start;
  start.position.z() = kRollingRadius + 0.1;
  start.velocity = {3.0, 0.0, -5.0};
  start.angular_velocity.y() = 3.0 / kRollingRadius;
  const std::vector<GroundParameters> zones{{0.25, 0.7, 0.5}, {0.25, 0.7, 0.5, length}};
  return simulate_release(terrain, zones, body, start, settings).final_state.angular_velocity.y();
}

/// The turn to the limit and the duration of an impact both go with (m/k_n)^(1/2).
TEST(RollingLength, MakesImpactsIndependentOfTheStiffness) {
  const double spin = spin_after_impact(1e8, 1.0, 0.1);
  const double start = 3.0 / kRollingRadius;
  ASSERT_LT(spin, 0.95 * start);  // it does resist
  for (const double stiffness : {2.5e7, 5e7, 2e8, 4e8}) {
    EXPECT_NEAR(spin_after_impact(stiffness, 1.0, 0.1), spin, 0.01 * (start - spin)) << stiffness;
  }
  // A k_r that is given does not scale so.
  EXPECT_NEAR(spin_after_impact(1e8, 1e6, 0.0), spin, 1e-9);
  EXPECT_GT(std::abs(spin_after_impact(4e8, 1e6, 0.0) - spin), 0.2 * (start - spin));
}

TEST(RollingLength, ShortensTheStepWhereItIsTheStiffestSpring) {
  const RigidBody body = box(1000.0, {1.0, 0.8, 0.6});
  const double moment = body.moments.minCoeff();
  StiffnessOptions options;
  options.normal = 1e8;
  const auto step = [&](const std::vector<GroundParameters>& zones) {
    return choose_stiffness(std::span(&body, 1), zones, 5.0, kTestGravity, options)
        .stiffness.time_step;
  };
  const GroundParameters plain{0.01, 0.7, 0.2}, small{0.01, 0.7, 0.2, 0.1},
      large{0.01, 0.7, 0.2, 3.0};
  EXPECT_EQ(step({small}), step({plain}));
  EXPECT_NEAR(step({plain, large}), 0.2 / std::sqrt(1e8 * 9.0 / moment), 1e-12);
  // A k_r that no zone uses does not count.
  const double unhindered = step({small});
  options.rolling = 9e8;
  EXPECT_EQ(step({small}), unhindered);
  EXPECT_LT(step({small, plain}), 0.9 * step({small}));
}

TEST(RollingLength, NegativeOnesAreRefused) {
  try {
    GroundParameters{0.01, 0.7, 0.2, -0.1}.check("scree");
    FAIL() << "accepted";
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()),
              "ground scree: rolling_length = -0.1; must be 0 m (no value) or more");
  }
}

}  // namespace
}  // namespace clast
