// Friction that grows with slip, and drag on what is in the ground, against closed forms.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/error.hpp"
#include "dem/contact/scar_drag.hpp"
#include "tests/support/gravity.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/test_worlds.hpp"

namespace clast {
namespace {

using dem_detail::embedded_frontal_area;
using dem_detail::EmbeddedFrontalArea;

GroundParameters growing(double friction_min, double friction, double growth, double memory = 0.0) {
  GroundParameters ground{0.5, friction, 0.0};
  ground.friction_min = friction_min;
  ground.slip_growth = growth;
  ground.slip_memory = memory;
  return ground;
}

GroundParameters dragging(double drag, double density) {
  GroundParameters ground{1.0, 0.0, 0.0};
  ground.scar_drag = drag;
  ground.soil_density = density;
  return ground;
}

/// At rest depth on flat ground, moving along x.
RigidState sliding_start(const RigidBody& body, const ReleaseSettings& settings,
                         double energy_restitution, double height, double speed) {
  RigidState start;
  start.position.z() =
      height - body.mass * kTestGravity / (settings.stiffness.normal * energy_restitution);
  start.velocity.x() = speed;
  return start;
}

/// Integral of mu over the way of sliding, m.
double friction_over(const GroundParameters& ground, double s) {
  const double k = ground.slip_growth;
  return ground.friction_min * s + 2.0 / kPi * (ground.friction - ground.friction_min) *
                                       (s * std::atan(k * s) - std::log1p(k * k * s * s) / (2 * k));
}

// v^2/2 = v_0^2/2 - g int mu ds all the way to the stop.
TEST(GrowingFriction, SlowsASlidingBlockAsItsIntegralSays) {
  const TerrainSurface terrain = ground(plane_mesh(20.0, 30));
  const RigidBody body = box(1000.0, {1.0, 1.0, 0.2});
  ReleaseSettings settings = stiff_settings(body, 1e8);
  settings.start_overlap = 1.0;
  const GroundParameters soil = growing(0.1, 0.8, 2.0);
  const RigidState start = sliding_start(body, settings, 0.5, 0.1, 5.0);
  double worst = 0.0;
  const ReleaseResult result = simulate_release(
      terrain, std::span(&soil, 1), body, start, settings, [&](const MotionStep& step) {
        const double v = step.end.velocity.x();
        if (v < 0.5) return;
        const double s = step.end.position.x();
        const double expected = 12.5 - kTestGravity * friction_over(soil, s);
        worst = std::max(worst, std::abs(0.5 * v * v - expected));
      });
  EXPECT_LT(worst, 0.05);
  double low = 0.0, high = 20.0;
  while (high - low > 1e-9) {
    const double middle = 0.5 * (low + high);
    (kTestGravity * friction_over(soil, middle) < 12.5 ? low : high) = middle;
  }
  EXPECT_EQ(result.stop_reason, StopReason::kRest);
  EXPECT_NEAR(result.final_state.position.x(), low, 0.005 * low);
  EXPECT_LT(result.energy.error, 0.005);
}

/// Speed of a ball after two bounces at which it slides, 0.1 s apart.
double speed_after_two_bounces(const GroundParameters& soil) {
  const TerrainSurface terrain = ground(plane_mesh(20.0, 10));
  const RigidBody body = ball(10.0, 0.2);
  ReleaseSettings settings = stiff_settings(body, 1e8);
  settings.max_time = 0.2;
  RigidState start;
  start.position.z() =
      0.2 + 0.5 * kTestGravity * 0.05 * 0.05;  // 0.05 s down, then 0.1 s up and down
  start.velocity.x() = 10.0;
  GroundParameters elastic = soil;
  elastic.energy_restitution = 1.0;
  const ReleaseResult result =
      simulate_release(terrain, std::span(&elastic, 1), body, start, settings);
  EXPECT_EQ(result.impacts, 2u);
  return result.final_state.velocity.x();
}

// Each bounce takes 2 mu v_n from the speed of a ball that slides. Almost all of the growth comes
// in the first: what is left of its slip 0.1 s later decides about the next.
TEST(GrowingFriction, ForgetsSlipAfterTheContact) {
  const double normal = kTestGravity * 0.05;
  const auto lost = [&](const GroundParameters& soil) {
    return (10.0 - speed_after_two_bounces(soil)) / (2.0 * normal);
  };
  // With mu constant, twice mu.
  EXPECT_NEAR(lost({1.0, 0.2, 0.0}), 0.4, 0.01);
  const double forgets = lost(growing(0.1, 0.3, 1e3, 0.0));
  const double keeps = lost(growing(0.1, 0.3, 1e3, 1e3));
  const double fades = lost(growing(0.1, 0.3, 1e3, 0.03));
  EXPECT_GT(keeps, 1.05 * forgets);
  EXPECT_GT(fades, forgets);
  EXPECT_LT(fades, keeps);
}

TEST(GrowingFriction, DoesNotGrowUnderABallThatRolls) {
  const TerrainSurface terrain = ground(plane_mesh(20.0, 10));
  const RigidBody body = ball(100.0, 0.3);
  ReleaseSettings settings = stiff_settings(body, 1e7);
  settings.start_overlap = 1.0;
  settings.max_time = 1.0;
  RigidState start = sliding_start(body, settings, 0.5, 0.3, 3.0);
  start.angular_velocity.y() = 10.0;
  const GroundParameters soil = growing(0.3, 2.0, 1e3);
  const ReleaseResult result =
      simulate_release(terrain, std::span(&soil, 1), body, start, settings);
  EXPECT_NEAR(result.final_state.velocity.x(), 3.0, 0.01);
  EXPECT_NEAR(result.energy.friction, 0.0, 0.5);
}

// Box upright, on its edge and on its corner, and a ball, against their geometry.
TEST(EmbeddedFrontalArea, IsTheAreaBelowTheGroundSeenAlongTheMotion) {
  const auto front_of = [](const RigidBody& body, const Quat& turn, double ground,
                           const Vec3& direction) {
    const dem_detail::BlockSurface surface(body.shape);
    const Quat back = turn.conjugate();
    EmbeddedFrontalArea front =
        embedded_frontal_area(surface.features, surface.radius, back * Vec3(0.0, 0.0, ground),
                              back * Vec3::UnitZ(), back * direction);
    front.centre = turn * front.centre;
    return front;
  };
  const RigidBody body = box(1000.0, {1.0, 0.8, 0.6}, 0.0, 3);
  const EmbeddedFrontalArea flat = front_of(body, Quat::Identity(), -0.25, Vec3::UnitX());
  EXPECT_NEAR(flat.area, 0.8 * 0.05, 1e-12);
  EXPECT_LT((flat.centre - Vec3(0.5, 0.0, -0.275)).norm(), 1e-12);
  // Skewed, the width seen is that of both sides.
  const Vec3 skew = Vec3(0.8, 0.6, 0.0);
  EXPECT_NEAR(front_of(body, Quat::Identity(), -0.25, skew).area, (0.8 * 0.8 + 0.6) * 0.05, 1e-12);
  // On an edge along y: 45 degrees, so that the front is as high as the depth.
  const Quat tilted(Eigen::AngleAxisd(0.25 * kPi, Vec3::UnitY()));
  const double lowest = -0.5 * (1.0 + 0.6) * std::sqrt(0.5);
  EXPECT_NEAR(front_of(body, tilted, lowest + 0.1, Vec3::UnitX()).area, 0.8 * 0.1, 1e-12);
  EXPECT_NEAR(front_of(body, tilted, lowest + 0.1, Vec3::UnitY()).area, 0.1 * 0.1, 1e-12);
  // A rounded box counts as its core, lowered by the radius.
  const RigidBody round = box(1000.0, {1.0, 0.8, 0.6}, 0.05);
  const EmbeddedFrontalArea rounded = front_of(round, Quat::Identity(), -0.30, Vec3::UnitX());
  EXPECT_NEAR(rounded.area, 0.8 * 0.05, 1e-12);
  EXPECT_NEAR(rounded.centre.z(), -0.325, 1e-12);
  // Half a ball: a half circle with its middle 4 r/(3 pi) below the centre.
  const EmbeddedFrontalArea half = front_of(ball(1.0, 0.5), Quat::Identity(), 0.0, Vec3::UnitX());
  EXPECT_NEAR(half.area, 0.5 * kPi * 0.25, 1e-12);
  EXPECT_NEAR(half.centre.z(), -4.0 * 0.5 / (3.0 * kPi), 1e-12);
  EXPECT_EQ(front_of(body, Quat::Identity(), -0.31, Vec3::UnitX()).area, 0.0);
}

// Heavy enough not to turn: v = v_0 exp(-C_d rho A x/(2 m)).
TEST(ScarDrag, SlowsASlidingBlockExponentiallyOverTheWay) {
  const TerrainSurface terrain = ground(plane_mesh(30.0, 30));
  RigidBody body = box(1000.0, {2.0, 1.0, 0.2});
  body.moments *= 1e6;
  ReleaseSettings settings = stiff_settings(body, 2e5, 60.0);
  settings.start_overlap = 1.0;
  settings.max_time = 3.0;
  const GroundParameters soil = dragging(1.5, 2000.0);
  const double depth = 1000.0 * kTestGravity / 2e5;
  const RigidState start = sliding_start(body, settings, 1.0, 0.1, 5.0);
  const ReleaseResult result =
      simulate_release(terrain, std::span(&soil, 1), body, start, settings);
  const double rate = 1.5 * 2000.0 * depth / (2.0 * 1000.0);
  const double displacement = result.final_state.position.x();
  EXPECT_NEAR(result.final_state.velocity.x(), 5.0 * std::exp(-rate * displacement), 0.005 * 5.0);
  EXPECT_NEAR(displacement, std::log1p(rate * 5.0 * 3.0) / rate, 0.01 * displacement);
  EXPECT_NEAR(result.energy.friction, 12500.0 - translational_energy(body, result.final_state),
              20.0);
  EXPECT_LT(result.energy.error, 1e-3);
}

// It acts below the centre, at the arm b of the segment: m (v_0 - v) b = J w, until v = w b.
TEST(ScarDrag, TurnsABallUntilItsFrontStandsStill) {
  const TerrainSurface terrain = ground(plane_mesh(60.0, 30));
  const RigidBody body = ball(100.0, 0.3);
  ReleaseSettings settings = stiff_settings(body, 2e4, 60.0);
  settings.start_overlap = 1.0;
  settings.max_time = 6.0;
  const GroundParameters soil = dragging(1.5, 2000.0);
  const double depth = 100.0 * kTestGravity / 2e4;
  const RigidState start = sliding_start(body, settings, 1.0, 0.3, 5.0);
  const ReleaseResult result =
      simulate_release(terrain, std::span(&soil, 1), body, start, settings);
  const double half = std::acos(1.0 - depth / 0.3);
  const double share = half - std::sin(half) * std::cos(half);
  const double arm = 2.0 / 3.0 * 0.3 * std::pow(std::sin(half), 3.0) / share;
  const double v = result.final_state.velocity.x(), w = result.final_state.angular_velocity.y();
  EXPECT_NEAR(100.0 * (5.0 - v) * arm, body.moments.y() * w, 0.002 * body.moments.y() * w);
  // u = v - w b falls as u_0/(1 + c u_0 t), c = C_d rho A (1/m + b^2/J)/2.
  const double area = 0.09 * share;
  const double rate = 0.5 * 1.5 * 2000.0 * area * (1.0 / 100.0 + arm * arm / body.moments.y());
  EXPECT_NEAR(v - w * arm, 5.0 / (1.0 + rate * 5.0 * 6.0), 0.01);
  EXPECT_LT(result.energy.error, 1e-3);
}

TEST(ScarDrag, BalancesInAWorld) {
  const TerrainSurface terrain = ground(plane_mesh(30.0, 30));
  const RigidBody body = box(200.0, {0.8, 0.6, 0.4});
  WorldSettings settings;
  settings.stiffness = stiff_settings(body, 1e6).stiffness;
  settings.law = ElastoplasticLaw();
  settings.stiffness.time_step *= 0.1;
  GroundParameters soil{0.04, 0.6, 0.2};
  soil.friction_min = 0.3;
  soil.slip_growth = 3.0;
  soil.slip_memory = 0.005;
  soil.scar_drag = 1.5;
  soil.soil_density = 1800.0;
  World world({body}, settings, terrain, {soil});
  RigidState start;
  start.position.z() = 1.0;
  start.velocity = {6.0, 1.0, -3.0};
  start.angular_velocity = {0.0, 4.0, 1.0};
  world.add_body(0, start);
  EXPECT_EQ(world.run_until_rest(20.0), StopReason::kRest);
  EXPECT_LT(world.energy_balance().error, 2e-3);
  EXPECT_GT(world.energy_balance().friction, 0.0);
}

TEST(GroundParameters, ThatDoNotGoTogetherAreRefused) {
  const auto refused = [](const GroundParameters& ground) {
    return refusal<InputError>([&] { ground.check("scree"); });
  };
  EXPECT_EQ(refused(growing(0.3, 0.8, 2.0, 0.1)), "");
  EXPECT_EQ(refused(dragging(1.5, 1800.0)), "");
  EXPECT_EQ(refused(growing(0.9, 0.8, 2.0)),
            "ground scree: friction_min = 0.9; must be at most friction, 0.8");
  EXPECT_TRUE(contains(refused(growing(0.3, 0.8, 0.0)), "slip_growth = 0; must be above 0 if"));
  EXPECT_TRUE(contains(refused(growing(0.0, 0.8, 0.0, 1.0)), "slip_growth = 0"));
  EXPECT_TRUE(contains(refused(growing(-0.1, 0.8, 1.0)), "friction_min = -0.1; must be 0 ("));
  EXPECT_TRUE(contains(refused(dragging(1.5, 0.0)), "soil_density = 0; must be above 0"));
  EXPECT_TRUE(contains(refused(dragging(0.0, 1800.0)), "scar_drag = 0; must be above 0"));
  EXPECT_TRUE(contains(refused(dragging(NAN, 1800.0)), "scar_drag = nan"));
}

}  // namespace
}  // namespace clast
