// Steps of a world: short in an impact and before one may begin, long between, and free flight.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/random.hpp"
#include "tests/support/test_worlds.hpp"

namespace clast {
namespace {

const std::vector<GroundParameters> kStepsGround = {{0.05, 0.7, 0.3}};

/// Every step has the length of an impact's, divided by `shortening`.
WorldSettings in_given_steps(WorldSettings settings, double shortening = 1.0) {
  settings.stiffness.time_step /= shortening;
  settings.stiffness.max_time_step = 0.0;
  return settings;
}

RigidBody tumbling() { return rock(3, {0.5, 0.42, 0.3}, 0.02, 2650.0, 4); }

TEST(WorldSteps, FlyAsFarAsNothingCanTouch) {
  const TerrainSurface terrain = ground(plane_mesh(20.0, 20));
  const RigidBody body = tumbling();
  const WorldSettings settings = automatic_world({body}, kStepsGround[0], 10.0);
  RigidState start = at({-3.0, 0.0, 4.0}, {6.0, 1.0, 2.0});
  start.angular_velocity = {3.0, -5.0, 1.0};
  World world({body}, settings, terrain, kStepsGround);
  std::vector<MotionStep> steps;
  world.set_observer([&](std::size_t, const MotionStep& step) { steps.push_back(step); });
  world.add_body(0, start);
  while (world.contact_summary(0).contact_count == 0 && world.time() < 5.0) world.step();
  const double landing = world.time();
  ASSERT_LT(landing, 2.0);
  EXPECT_LT(static_cast<double>(steps.size()), 0.25 * landing / settings.stiffness.time_step);
  std::size_t flights = 0;
  for (const MotionStep& step : steps) {
    EXPECT_TRUE(step.flight);
    if (step.contact_summary.contact_count > 0) continue;  // at landing
    ++flights;
    const RigidState exact = free_flight(body, start, step.end_time, 9.81);
    EXPECT_LT((step.end.position - exact.position).norm(), 1e-9);
    EXPECT_LT(step.end.orientation.angularDistance(exact.orientation), 1e-6);
  }
  EXPECT_GT(flights, 20u);
  // It is found as early as short steps find it.
  EXPECT_LT(world.contact_summary(0).overlap,
            1.5 * steps.back().end.velocity.norm() * settings.stiffness.time_step);
}

TEST(WorldSteps, ABodyFliesWhileOthersTouch) {
  const TerrainSurface terrain = ground(plane_mesh(20.0, 20));
  const RigidBody body = ball(10.0, 0.2);
  World world({body}, automatic_world({body}, kStepsGround[0], 10.0), terrain, kStepsGround);
  std::array<double, 2> flown{};
  world.set_observer([&](std::size_t i, const MotionStep& step) {
    if (step.flight) flown[i] += step.end_time - step.begin_time;
  });
  world.add_body(0, at({0.0, 0.0, 0.1999}, {2.0, 0.0, 0.0}));
  world.add_body(0, at({0.0, 3.0, 2.2}));
  while (world.contact_summary(1).contact_count == 0 && world.time() < 2.0) world.step();
  EXPECT_NEAR(world.time(), std::sqrt(2.0 * 2.0 / 9.81), 2e-3);
  EXPECT_NEAR(flown[1], world.time(), 1e-12);
  EXPECT_LT(flown[0], 0.05 * world.time());
}

TEST(WorldSteps, OfAGivenLengthAreKept) {
  const TerrainSurface terrain = ground(plane_mesh(20.0, 20));
  const WorldSettings settings =
      in_given_steps(automatic_world({tumbling()}, kStepsGround[0], 10.0));
  World world({tumbling()}, settings, terrain, kStepsGround);
  std::size_t points = 0;
  world.set_observer([&](std::size_t, const MotionStep& step) {
    EXPECT_EQ(step.flight, points == 0);
    points = step.contact_summary.contact_count;
    EXPECT_NEAR(step.end_time - step.begin_time, settings.stiffness.time_step, 1e-12);
  });
  world.add_body(0, at({0.0, 0.0, 1.5}, {2.0, 0.0, 0.0}));
  for (int i = 0; i < 2000; ++i) world.step();
  EXPECT_GT(world.contact_summary(0).contact_count, 0u);
}

/// Velocities of two bodies after they met in flight.
std::vector<Vec3> after_meeting(const WorldSettings& settings, const RigidState& a,
                                const RigidState& b) {
  World world({tumbling(), box(150.0, {0.5, 0.4, 0.45}, 0.02)}, settings);
  world.add_body(0, a);
  world.add_body(1, b);
  const Vec3 before = world.linear_momentum();
  bool met = false;
  while (world.time() < 1.0) {
    world.step();
    met = met || world.overlap(0, 1) > 0.0;
  }
  EXPECT_TRUE(met);
  EXPECT_LT((world.linear_momentum() - before).norm(), 1e-9 * before.norm());
  EXPECT_LT(world.energy_balance().error, 0.01);
  return {world.state(0).velocity, world.state(1).velocity};
}

TEST(WorldSteps, MissNoMeetingInFlight) {
  Random random(3);
  WorldSettings settings =
      automatic_world({tumbling(), box(150.0, {0.5, 0.4, 0.45}, 0.02)}, kStepsGround[0], 10.0);
  settings.gravity = 0.0;
  double steps_apart = 0.0, given_apart = 0.0;
  for (int trial = 0; trial < 30; ++trial) {
    RigidState a = at({-2.0, 0.0, 0.0}, {4.0, 0.0, 0.0});
    RigidState b =
        at({2.0, random.uniform(-0.2, 0.2), random.uniform(-0.2, 0.2)}, {-5.0, 0.3, 0.0});
    a.orientation = random.rotation();
    b.orientation = random.rotation();
    a.angular_velocity = 4.0 * random.unit_vector();
    b.angular_velocity = 4.0 * random.unit_vector();
    const std::vector<Vec3> exact = after_meeting(in_given_steps(settings, 16.0), a, b);
    const std::vector<Vec3> found = after_meeting(settings, a, b);
    const std::vector<Vec3> given = after_meeting(in_given_steps(settings), a, b);
    for (int i = 0; i < 2; ++i) {
      steps_apart += (found[i] - exact[i]).norm() / 60.0;
      given_apart += (given[i] - exact[i]).norm() / 60.0;
    }
  }
  // As good as if all steps were those of the impact; speeds are 4 and 5 m/s.
  EXPECT_LT(steps_apart, 1.25 * given_apart + 0.01);
  EXPECT_LT(given_apart, 0.15);
}

TEST(WorldSteps, OfABlockOnASlopeSaveWorkAndKeepTheBalance) {
  const TerrainSurface terrain = ground(rough_slope(60, 0.5, 0.5, 0.10));
  const RigidBody body = tumbling();
  const auto run = [&](const WorldSettings& settings) {
    World world({body}, settings, terrain, kStepsGround);
    RigidState start = at({-8.0, 0.0, *terrain.height_at(-8.0, 0.0, 0.0) + 2.0});
    start.orientation = Random(8).rotation();
    world.add_body(0, start);
    world.run_until_rest(10.0);
    EXPECT_LT(world.energy_balance().error, 0.005);
    EXPECT_LT(std::abs(world.energy_balance().reassigned),
              0.05 * world.energy_balance().dissipated());
    return static_cast<double>(world.statistics().steps) / world.time();
  };
  const WorldSettings settings = automatic_world({body}, kStepsGround[0], 10.0);
  const double by_phase = run(settings), given = run(in_given_steps(settings));
  EXPECT_LT(by_phase, 0.7 * given);
}

}  // namespace
}  // namespace clast
