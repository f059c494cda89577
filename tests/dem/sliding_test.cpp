// Sliding, rolling and rest against closed forms.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "core/angle.hpp"
#include "tests/support/gravity.hpp"
#include "tests/support/test_bodies.hpp"

namespace clast {
namespace {

/// A start in contact at the depth at which the unloaded spring carries the body on a slope.
RigidState resting_start(const RigidBody& body, const ReleaseSettings& settings, double restitution,
                         double slope, double height_of_centre) {
  const Vec3 normal(std::sin(slope), 0.0, std::cos(slope));
  const double depth =
      body.mass * kTestGravity * std::cos(slope) / (settings.stiffness.normal * restitution);
  RigidState start;
  start.position = (height_of_centre - depth) * normal;
  start.orientation = Quat(Eigen::AngleAxisd(slope, Vec3::UnitY()));
  return start;
}

double velocity_along(const RigidState& state, double slope) {
  return state.velocity.dot(Vec3(std::cos(slope), 0.0, -std::sin(slope)));
}

TEST(Sliding, BlockOnThirtyDegrees) {
  const double slope = kPi / 6;
  const TerrainSurface terrain = ground(plane_mesh(60.0, 40, slope));
  const RigidBody body = box(1000.0, {1.0, 1.0, 0.3});
  ReleaseSettings settings = stiff_settings(body, 1e8);
  settings.start_overlap = 1.0;
  settings.max_time = 1.0;
  const RigidState start = resting_start(body, settings, 0.5, slope, 0.15);
  double first_speed = -1.0, first_time = 0.0;
  const ReleaseResult result =
      simulate_release(terrain, std::vector<GroundParameters>{{0.5, 0.3, 0.0}}, body, start,
                       settings, [&](const MotionStep& step) {
                         if (first_speed >= 0.0 || step.end_time < 0.2) return;
                         first_speed = velocity_along(step.end, slope);
                         first_time = step.end_time;
                       });
  const double acceleration =
      (velocity_along(result.final_state, slope) - first_speed) / (result.duration - first_time);
  EXPECT_NEAR(acceleration, 2.3563, 1e-3);
  EXPECT_LT(result.energy.error, 0.005);
}

TEST(Sliding, StopsOnTheFlat) {
  const TerrainSurface terrain = ground(plane_mesh(20.0, 30));
  const RigidBody body = box(1000.0, {1.0, 1.0, 0.2});
  ReleaseSettings settings = stiff_settings(body, 1e8);
  settings.start_overlap = 1.0;
  RigidState start = resting_start(body, settings, 0.5, 0.0, 0.1);
  start.velocity.x() = 5.0;
  double stopped = -1.0;
  const ReleaseResult result =
      simulate_release(terrain, std::vector<GroundParameters>{{0.5, 0.3, 0.0}}, body, start,
                       settings, [&](const MotionStep& step) {
                         if (stopped < 0.0 && step.end.velocity.x() <= 0.0) stopped = step.end_time;
                       });
  EXPECT_EQ(result.stop_reason, StopReason::kRest);
  EXPECT_NEAR(result.final_state.position.x(), 4.2474, 0.005 * 4.2474);
  EXPECT_NEAR(stopped, 1.6989, 0.005 * 1.6989);
  EXPECT_LT(result.energy.error, 0.005);
}

struct Hold {
  double friction;
  ContactLaw law;
};
void PrintTo(const Hold& hold, std::ostream* out) {
  *out << name_of(hold.law) << ", friction " << hold.friction;
}

class StaticLimit : public testing::TestWithParam<Hold> {};

// 34.99 degrees for 0.70 and 16.70 for 0.30: no creep for a minute just below, none stopped above.
TEST_P(StaticLimit, HoldsBelowAndSlidesAbove) {
  const auto& [friction, law] = GetParam();
  const double limit = std::atan(friction);
  for (const double degrees : {-0.3, 0.3}) {
    const double slope = limit + degrees * kRadiansPerDegree;
    const TerrainSurface terrain = ground(plane_mesh(60.0, 20, slope));
    const RigidBody body = box(1000.0, {1.0, 1.0, 0.2});
    ReleaseSettings settings = stiff_settings(body, 1e8, 20.0);
    settings.law = law;
    settings.start_overlap = 1.0;
    settings.rest_energy = 1e-300;
    settings.max_time = degrees < 0.0 ? 60.0 : 10.0;
    const bool dashpot = std::holds_alternative<SpringDashpotLaw>(law);
    const RigidState start = resting_start(body, settings, dashpot ? 1.0 : 0.01, slope, 0.1);
    const Vec3 along(std::cos(slope), 0.0, -std::sin(slope));
    std::optional<Vec3> after_one;
    double farthest = 0.0;
    simulate_release(
        terrain, std::vector<GroundParameters>{{0.01, friction, 0.0}}, body, start, settings,
        [&](const MotionStep& step) {
          if (step.end_time < 1.0) return;
          if (!after_one) after_one = step.end.position;
          const Vec3 moved = step.end.position - *after_one;
          farthest = std::max({farthest, std::abs(moved.dot(along)), std::abs(moved.y())});
        });
    if (degrees < 0) {
      EXPECT_LT(farthest, 1e-3);
    } else {
      EXPECT_GT(farthest, 0.5);
    }
  }
}
INSTANTIATE_TEST_SUITE_P(Frictions, StaticLimit,
                         testing::Values(Hold{0.70, EnergyRestitutionLaw()},
                                         Hold{0.30, EnergyRestitutionLaw()},
                                         Hold{0.70, SpringDashpotLaw()},
                                         Hold{0.30, SpringDashpotLaw()}));

TEST(Rolling, SphereOnThirtyDegrees) {
  const double slope = kPi / 6;
  const TerrainSurface terrain = ground(plane_mesh(60.0, 40, slope));
  const RigidBody body = ball(100.0, 0.3);
  ReleaseSettings settings = stiff_settings(body, 1e8);
  settings.start_overlap = 1.0;
  settings.max_time = 1.0;
  const RigidState start = resting_start(body, settings, 0.5, slope, 0.3);
  const auto after_one = [&](double friction) {
    return simulate_release(terrain, std::vector<GroundParameters>{{0.5, friction, 0.0}}, body,
                            start, settings)
        .final_state;
  };
  EXPECT_NEAR(velocity_along(after_one(0.3), slope), 3.5036, 0.01);
  const RigidState slipping = after_one(0.1);
  EXPECT_NEAR(velocity_along(slipping, slope), 4.0554, 0.01);
  EXPECT_NEAR(0.3 * slipping.angular_velocity.norm(), 2.1239, 0.01);
}

TEST(Rolling, ResistanceStopsASphere) {
  for (const auto& [rolling, distance] : {std::pair{0.35, 5.0968}, std::pair{0.18, 9.9105}}) {
    const TerrainSurface terrain = ground(plane_mesh(30.0, 40));
    const RigidBody body = ball(100.0, 0.3);
    ReleaseSettings settings = stiff_settings(body, 1e8);
    settings.start_overlap = 1.0;
    RigidState start = resting_start(body, settings, 0.5, 0.0, 0.3);
    start.velocity.x() = 5.0;
    start.angular_velocity.y() = 5.0 / 0.3;
    const ReleaseResult result = simulate_release(
        terrain, std::vector<GroundParameters>{{0.5, 0.7, rolling}}, body, start, settings);
    EXPECT_EQ(result.stop_reason, StopReason::kRest);
    EXPECT_NEAR(result.final_state.position.x(), distance, 0.02 * distance);
  }
}

// The springs of friction and rolling follow the contact from face to face: a ball held by them on
// a slope of many faces stops where it stops on two triangles.
TEST(Rolling, HistoryIsKeptAtInnerEdges) {
  std::vector<double> stops;
  for (const int cells : {1, 300}) {
    const TerrainSurface terrain = ground(plane_mesh(15.0, cells));
    const RigidBody body = ball(100.0, 0.3);
    ReleaseSettings settings = stiff_settings(body, 1e8);
    settings.start_overlap = 1.0;
    RigidState start = resting_start(body, settings, 0.5, 0.0, 0.3);
    start.velocity.x() = 3.0;
    start.angular_velocity.y() = 10.0;
    const ReleaseResult result = simulate_release(
        terrain, std::vector<GroundParameters>{{0.5, 0.7, 0.35}}, body, start, settings);
    EXPECT_EQ(result.stop_reason, StopReason::kRest);
    stops.push_back(result.final_state.position.x());
  }
  EXPECT_GT(stops[0], 1.0);
  EXPECT_NEAR(stops[1], stops[0], 1e-6);
}

TEST(Rolling, SlidingLaunchEndsAtFiveSevenths) {
  const TerrainSurface terrain = ground(plane_mesh(20.0, 30));
  const RigidBody body = ball(100.0, 0.3);
  ReleaseSettings settings = stiff_settings(body, 1e8);
  settings.start_overlap = 1.0;
  settings.max_time = 1.5;
  RigidState start = resting_start(body, settings, 0.5, 0.0, 0.3);
  start.velocity.x() = 4.0;
  const RigidState end = simulate_release(terrain, std::vector<GroundParameters>{{0.5, 0.4, 0.0}},
                                          body, start, settings)
                             .final_state;
  EXPECT_NEAR(end.velocity.x(), 5.0 / 7.0 * 4.0, 0.01);
}

TEST(Determinism, RepeatedRunsGiveTheSameBits) {
  const TerrainSurface terrain = ground(rough_slope(60, 0.5, 0.6, 0.1));
  const RigidBody body = box(300.0, {0.8, 0.6, 0.4}, 0.02);
  ReleaseSettings settings = stiff_settings(body, 3e7, 20.0);
  settings.max_time = 5.0;
  RigidState start;
  start.position = {-8.0, 0.0, 7.5};
  start.orientation = Random(5).rotation();
  const std::vector<GroundParameters> zones{{0.01, 0.7, 0.2}};
  const ReleaseResult first = simulate_release(terrain, zones, body, start, settings);
  const ReleaseResult second = simulate_release(terrain, zones, body, start, settings);
  EXPECT_EQ(first.final_state.position, second.final_state.position);
  EXPECT_EQ(first.final_state.orientation.coeffs(), second.final_state.orientation.coeffs());
  EXPECT_GT(first.impacts, 2u);
}

}  // namespace
}  // namespace clast
