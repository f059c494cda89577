#include "study/results/impact.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/gravity.hpp"
#include "tests/support/test_bodies.hpp"

namespace clast {
namespace {

ImpactObserver seen(const RigidBody& body, const TerrainSurface& terrain, const RigidState& start,
                    double restitution, const ReleaseSettings& settings) {
  ImpactObserver observer(body, 7);
  const std::vector<GroundParameters> zones = {{restitution, 0.0, 0.0}};
  simulate_release(terrain, zones, body, start, settings,
                   [&](const MotionStep& step) { observer.observe_step(step); });
  observer.finish();
  return observer;
}

TEST(Impact, BouncesOfABallAreThoseOfTheFormulas) {
  const double mass = 200.0, radius = 0.4, fall = 2.0, restitution = 0.25;
  const RigidBody body = ball(mass, radius);
  const TerrainSurface terrain = ground(plane_mesh(20.0, 4));
  ReleaseSettings settings = stiff_settings(body, 1e8);
  settings.gravity = kTestGravity;
  settings.max_time = 2.0;
  RigidState start;
  start.position = Vec3(0.3, 0.2, radius + fall);
  start.velocity = Vec3(1.0, 0.0, 0.0);
  const ImpactObserver observer = seen(body, terrain, start, restitution, settings);
  ASSERT_GE(observer.impacts.size(), 2u);

  const Impact& first = observer.impacts[0];
  const double down = std::sqrt(2 * kTestGravity * fall), touch = down / kTestGravity;
  EXPECT_EQ(first.run, 7u);
  EXPECT_EQ(first.zone, 0u);
  EXPECT_NEAR(first.time, touch, 1e-6);
  EXPECT_NEAR(first.speed_before, std::hypot(down, 1.0), 1e-5);
  EXPECT_NEAR(first.translational_before, 0.5 * mass * (down * down + 1.0), 1e-2);
  // e_n^2 of the energy along the normal comes back; the ground is frictionless.
  EXPECT_NEAR(first.translational_after, 0.5 * mass * (restitution * down * down + 1.0),
              0.01 * mass * kTestGravity * fall);
  EXPECT_NEAR(first.rotational_after, 0.0, 1e-6);
  // Half a period of the spring in, and 1/e_n of that out; depth v sqrt(m/k).
  const double quarter = 0.5 * kPi * std::sqrt(mass / settings.stiffness.normal);
  EXPECT_NEAR(first.contact_duration, quarter * (1 + 1 / std::sqrt(restitution)), 0.05 * quarter);
  EXPECT_NEAR(first.depth, down * std::sqrt(mass / settings.stiffness.normal), 0.02 * first.depth);
  EXPECT_NEAR(first.position.x(), 0.3 + touch, 1e-4);
  EXPECT_NEAR(first.position.y(), 0.2, 1e-6);
  EXPECT_NEAR(first.position.z(), 0.0, 1e-4);

  const double up = std::sqrt(restitution) * down;
  EXPECT_NEAR(observer.impacts[1].time - first.time, 2 * up / kTestGravity, 0.02);
  EXPECT_NEAR(observer.impacts[1].speed_before, std::hypot(up, 1.0), 0.01 * up);

  const ContactStatistics& statistics = observer.statistics;
  EXPECT_EQ(statistics.max_contact_points, 1u);
  EXPECT_NEAR(statistics.mean_contact_points, 1.0, 0.2);
  EXPECT_NEAR(statistics.longest_flight, 2 * up / kTestGravity, 0.02);
  EXPECT_NEAR(statistics.max_energy, 0.5 * mass * (down * down + 1.0), 1.0);
  EXPECT_NEAR(statistics.max_spin, 0.0, 1e-6);
}

// A step made by hand, at 1 m/s along x.
MotionStep step(double begin, double end, bool flight, std::uint32_t points, double overlap,
                double speed = 1.0) {
  MotionStep made;
  made.begin_time = begin;
  made.end_time = end;
  made.begin.position = Vec3(begin, 0, 0);
  made.end.position = Vec3(end, 0, 0);
  made.begin.velocity = made.end.velocity = Vec3(speed, 0, 0);
  made.flight = flight;
  made.contact_summary = {points, overlap, Vec3(end, 0, 0), 2};
  return made;
}

TEST(Impact, ShortFlightsDoNotEndIt) {
  const RigidBody body = ball(2.0, 0.5);
  ImpactObserver observer(body, 1);
  observer.observe_step(step(0.0, 0.5, true, 1, 0.0, 4.0));  // first touch
  observer.observe_step(step(0.5, 0.6, false, 2, 0.03, 3.0));
  observer.observe_step(step(0.6, 0.61, false, 0, 0.0, 3.0));   // free
  observer.observe_step(step(0.61, 0.615, true, 1, 0.0, 3.0));  // 5 ms: the same impact
  observer.observe_step(step(0.615, 0.7, false, 4, 0.01, 2.0));
  observer.observe_step(step(0.7, 0.71, false, 0, 0.0, 2.0));
  observer.observe_step(step(0.71, 0.716, true, 0, 0.0, 2.0));  // two pieces of one flight of 12 ms
  observer.observe_step(step(0.716, 0.722, true, 3, 0.0, 2.0));
  observer.observe_step(step(0.722, 0.8, false, 3, 0.02, 0.0));  // until the end of the run
  observer.finish();
  ASSERT_EQ(observer.impacts.size(), 2u);
  const Impact& first = observer.impacts[0];
  EXPECT_EQ(first.zone, 2u);
  EXPECT_EQ(first.time, 0.5);
  EXPECT_NEAR(first.contact_duration, 0.21, 1e-12);
  EXPECT_EQ(first.speed_before, 4.0);
  EXPECT_EQ(first.speed_after, 2.0);
  EXPECT_EQ(first.translational_before, 16.0);
  EXPECT_EQ(first.translational_after, 4.0);
  EXPECT_EQ(first.depth, 0.03);
  EXPECT_EQ(observer.impacts[1].time, 0.722);
  EXPECT_EQ(observer.impacts[1].translational_after, 0.0);
  EXPECT_EQ(observer.impacts[1].depth, 0.02);
  const ContactStatistics& statistics = observer.statistics;
  EXPECT_NEAR(statistics.contact_time, 0.1 + 0.01 + 0.085 + 0.01 + 0.078, 1e-12);
  EXPECT_NEAR(statistics.mean_contact_points,
              (0.2 + 4 * 0.085 + 3 * 0.078) / statistics.contact_time, 1e-12);
  EXPECT_EQ(statistics.max_contact_points, 4u);
  EXPECT_NEAR(statistics.longest_flight, 0.5, 1e-12);
}

TEST(Impact, RunThatStartsInContactHasNoneBeforeItsFirstFlight) {
  const RigidBody body = ball(2.0, 0.5);
  ImpactObserver observer(body, 1);
  observer.observe_step(step(0.0, 0.5, false, 1, 0.01));
  observer.observe_step(step(0.5, 0.6, false, 0, 0.0));
  observer.observe_step(step(0.6, 0.8, true, 0, 0.0));
  observer.finish();
  EXPECT_TRUE(observer.impacts.empty());
}

}  // namespace
}  // namespace clast
