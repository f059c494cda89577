// Steps by phase: impacts are resolved, and what goes on between them takes longer steps.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include <Eigen/Eigenvalues>

#include "dem/contact/stiffness.hpp"
#include "tests/support/gravity.hpp"
#include "tests/support/test_bodies.hpp"

namespace clast {
namespace {

/// What `auto` takes.
ReleaseSettings automatic(const RigidBody& body, const GroundParameters& zone,
                          const StiffnessOptions& options = {}) {
  ReleaseSettings settings;
  settings.stiffness =
      choose_stiffness(std::span(&body, 1), std::span(&zone, 1), 5.0, kTestGravity, options)
          .stiffness;
  return settings;
}

RigidBody phase_rock() { return box(1.0, {0.3, 0.2, 0.15}); }

// By the closed form, and as a matrix.
TEST(DepositMobility, IsTheLargestEigenvalueAtEachVertex) {
  RigidBody body = phase_rock();
  body.shape.radius = 0.02;
  const std::vector<double> mobilities = vertex_mobilities(body);
  ASSERT_EQ(mobilities.size(), body.shape.vertices.size());
  for (std::size_t v = 0; v < mobilities.size(); ++v) {
    const Vec3 out = body.shape.vertices[v].normalized();
    const Vec3 x = body.shape.vertices[v] + 0.02 * out;
    Mat3 cross;
    cross << 0, -x.z(), x.y(), x.z(), 0, -x.x(), -x.y(), x.x(), 0;
    const Mat3 mobility = Mat3::Identity() / body.mass +
                          cross.transpose() * body.moments.cwiseInverse().asDiagonal() * cross;
    const Eigen::SelfAdjointEigenSolver<Mat3> solver(mobility, Eigen::EigenvaluesOnly);
    EXPECT_NEAR(mobilities[v], solver.eigenvalues()[2], 1e-7 * mobilities[v]);
  }
}

TEST(DepositMobility, OfABallIsSevenHalvesOfItsInverseMass) {
  EXPECT_NEAR(vertex_mobilities(ball(4.0, 0.3))[0], 3.5 / 4.0, 1e-7);
}

struct PhaseImpact {
  const char* name;
  bool corner;  ///< of a box, else a ball
  double angle;
  double energy_restitution;
};
void PrintTo(const PhaseImpact& impact, std::ostream* out) { *out << impact.name; }

/// Velocity of the centre after an oblique impact at 1 m/s with friction and rolling resistance.
Vec3 after_impact(const PhaseImpact& impact, double gap, double step, double longest) {
  static const TerrainSurface terrain = ground(plane_mesh(3.0, 5));
  const RigidBody body = impact.corner ? phase_rock() : ball(1.0, 0.1);
  const double k = 1e6, arm = 0.5 * body.smallest_side;
  const double frequency = std::sqrt(k * body_stiffness_inputs(body).mobility);
  ReleaseSettings settings;
  settings.stiffness = {k, k, k * arm * arm, step / frequency, longest / frequency};
  settings.gravity = 0.0;
  settings.max_time = gap / std::sin(impact.angle) + 0.1;
  RigidState start;
  if (impact.corner) {
    start.orientation =
        Quat(Eigen::AngleAxisd(0.5, Vec3::UnitY())) * Quat(Eigen::AngleAxisd(0.3, Vec3::UnitX()));
  }
  double below = 0.0;
  for (const Vec3& vertex : body.shape.vertices) {
    below = std::max(below, body.shape.radius - (start.orientation * vertex).z());
  }
  start.position = {0.1, 0.2, below + gap};
  start.velocity = {std::cos(impact.angle), 0.0, -std::sin(impact.angle)};
  const GroundParameters zone{impact.energy_restitution, 0.5, 0.2};
  return simulate_release(terrain, std::span(&zone, 1), body, start, settings).final_state.velocity;
}

class StepPhases : public testing::TestWithParam<PhaseImpact> {};

// The velocity that the impact leaves is as exact as with the short step throughout.
TEST_P(StepPhases, CostAnImpactNothing) {
  double fixed = 0.0, phases = 0.0;
  const std::vector<double> gaps = {0.01, 0.0101, 0.01023, 0.0104};
  for (const double gap : gaps) {
    const Vec3 exact = after_impact(GetParam(), gap, 0.005, 0.0);
    fixed = std::max(fixed, (after_impact(GetParam(), gap, 0.2, 0.0) - exact).norm());
    phases = std::max(phases, (after_impact(GetParam(), gap, 0.2, 0.4) - exact).norm());
  }
  RecordProperty("fixed", std::to_string(fixed));
  RecordProperty("phases", std::to_string(phases));
  EXPECT_LT(fixed, 0.04);
  EXPECT_LT(phases, fixed + 0.01);
}

INSTANTIATE_TEST_SUITE_P(Impacts, StepPhases,
                         testing::Values(PhaseImpact{"ball_grazing", false, 0.1, 0.01},
                                         PhaseImpact{"ball_oblique", false, 0.8, 0.01},
                                         PhaseImpact{"ball_oblique_bouncing", false, 0.8, 0.5},
                                         PhaseImpact{"ball_steep_bouncing", false, 1.5, 0.5},
                                         PhaseImpact{"corner_grazing", true, 0.1, 0.01},
                                         PhaseImpact{"corner_flat", true, 0.3, 0.01},
                                         PhaseImpact{"corner_oblique", true, 0.8, 0.01},
                                         PhaseImpact{"corner_oblique_bouncing", true, 0.8, 0.5},
                                         PhaseImpact{"corner_steep", true, 1.5, 0.01},
                                         PhaseImpact{"corner_steep_bouncing", true, 1.5, 0.5}),
                         [](const auto& test) { return std::string(test.param.name); });

/// A body that rests on a slope of 30 degrees is let go.
struct Descent {
  double speed = 0.0;  ///< along the slope after one second, m/s
  double depth = 0.0;  ///< settled, m
};
Descent descent(const RigidBody& body, double half_height, const GroundParameters& zone) {
  const double slope = kPi / 6;
  const TerrainSurface terrain = ground(plane_mesh(60.0, 40, slope));
  ReleaseSettings settings = automatic(body, zone);
  settings.start_overlap = 1.0;
  settings.max_time = 1.0;
  const Vec3 normal(std::sin(slope), 0.0, std::cos(slope));
  const double depth = body.mass * kTestGravity * std::cos(slope) /
                       (settings.stiffness.normal * zone.energy_restitution);
  RigidState start;
  start.position = (half_height - depth) * normal;
  start.orientation = Quat(Eigen::AngleAxisd(slope, Vec3::UnitY()));
  const RigidState end =
      simulate_release(terrain, std::span(&zone, 1), body, start, settings).final_state;
  return {end.velocity.dot(Vec3(std::cos(slope), 0.0, -std::sin(slope))), depth};
}

// g (sin a - mu cos a).
TEST(StepPhases, SlidingKeepsItsAcceleration) {
  const double expected = kTestGravity * (0.5 - 0.3 * std::sqrt(0.75));
  const Descent slide = descent(box(1000.0, {1.0, 1.0, 0.3}), 0.15, {0.01, 0.3, 0.0});
  EXPECT_NEAR(slide.speed, expected, 2e-3 * expected);
}

// g sin a / (1 + 2/5 R^2/r^2): friction acts in the middle of the overlap, r = R - depth/2.
TEST(StepPhases, RollingKeepsItsAcceleration) {
  const Descent roll = descent(ball(100.0, 0.3), 0.3, {0.01, 0.7, 0.0});
  const double ratio = 0.3 / (0.3 - 0.5 * roll.depth);
  const double expected = 0.5 * kTestGravity / (1.0 + 0.4 * ratio * ratio);
  EXPECT_NEAR(roll.speed, expected, 2e-3 * expected);
}

// Four corners that carry the full stiffness each are twice as fast as one.
TEST(StepPhases, FollowAllContactsTogether) {
  const RigidBody body = box(1000.0, {1.0, 1.0, 0.3});
  const GroundParameters zone{0.01, 0.7, 0.0};
  ReleaseSettings settings = automatic(body, zone);
  settings.weighting = ContactWeighting::kNone;
  const TerrainSurface terrain = ground(plane_mesh(5.0, 3));
  RigidState start;
  start.position.z() = 0.25;
  double at_rest = 0.0;
  const ReleaseResult result =
      simulate_release(terrain, std::span(&zone, 1), body, start, settings,
                       [&](const MotionStep& step) { at_rest = step.end_time - step.begin_time; });
  EXPECT_EQ(result.stop_reason, StopReason::kRest);
  EXPECT_NEAR(at_rest, 0.5 * settings.stiffness.max_time_step,
              1e-6 * settings.stiffness.max_time_step);
  EXPECT_LT(result.energy.error, 1e-4);
  EXPECT_LT(result.max_speed, 1.5);
}

TEST(StepPhases, AreThoseOfAutoAndAGivenStepIsKept) {
  const RigidBody body = ball(100.0, 0.3);
  const GroundParameters zone{0.01, 0.7, 0.1};
  const TerrainSurface terrain = ground(plane_mesh(20.0, 5));
  RigidState start;
  start.position.z() = 0.5;
  start.velocity.x() = 3.0;
  const auto steps = [&](const ReleaseSettings& settings) {
    std::vector<double> lengths;
    simulate_release(terrain, std::span(&zone, 1), body, start, settings,
                     [&](const MotionStep& step) {
                       if (!step.flight) lengths.push_back(step.end_time - step.begin_time);
                     });
    return lengths;
  };
  const ReleaseSettings settings = automatic(body, zone);
  const std::vector<double> lengths = steps(settings);
  ASSERT_GT(lengths.size(), 100u);
  const double shortest = settings.stiffness.time_step;
  EXPECT_NEAR(lengths.front(), shortest, 1e-9);
  EXPECT_NEAR(*std::max_element(lengths.begin(), lengths.end()), 2.0 * shortest, 1e-9);
  StiffnessOptions given;
  given.time_step = 0.5 * shortest;
  for (const double length : steps(automatic(body, zone, given))) {
    EXPECT_NEAR(length, 0.5 * shortest, 1e-9);
  }
}

}  // namespace
}  // namespace clast
