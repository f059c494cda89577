// Single impacts and flights against closed forms.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "core/error.hpp"
#include "tests/support/test_bodies.hpp"

namespace clast {
namespace {

/// Mean of a quantity at the first step without contact after one with contact.
struct Rebound {
  RigidState state;
  double contact_time = 0.0;
  bool left = false;
};

struct ReboundWatch {
  const RigidBody& body;
  Rebound rebound;
  double begin = -1.0;
  void operator()(const MotionStep& step) {
    if (rebound.left) return;
    if (!step.flight && begin < 0.0) begin = step.begin_time;
    if (step.flight && begin >= 0.0) {
      rebound = {step.begin, step.begin_time - begin, true};
    }
  }
};

Rebound first_rebound(const TerrainSurface& terrain, const GroundParameters& zone,
                      const RigidBody& body, const RigidState& start,
                      const ReleaseSettings& settings, ReleaseResult* result = nullptr) {
  ReboundWatch watch{body, {}};
  const ReleaseResult run = simulate_release(terrain, std::span(&zone, 1), body, start, settings,
                                             [&](const MotionStep& step) { watch(step); });
  if (result) *result = run;
  return watch.rebound;
}

class NormalImpact : public testing::TestWithParam<double> {};

// Without gravity: depth v sqrt(m/k), loading for a quarter period, unloading 1/e_n times that.
TEST_P(NormalImpact, ReturnsTheAskedRestitution) {
  const double restitution = GetParam();
  const TerrainSurface terrain = ground(plane_mesh(1.0, 6));
  const RigidBody body = ball(1.0, 0.1);
  ReleaseSettings settings = stiff_settings(body, 1e6, 200.0);
  settings.gravity = 0.0;
  settings.max_time = 0.3;
  RigidState start;
  start.position = {0.05, 0.02, 0.15};
  start.velocity = {0.0, 0.0, -1.0};
  ReleaseResult result;
  const Rebound rebound =
      first_rebound(terrain, {restitution, 0.5, 0.0}, body, start, settings, &result);
  ASSERT_TRUE(rebound.left);
  EXPECT_NEAR(rebound.state.velocity.z(), std::sqrt(restitution), 0.005 * std::sqrt(restitution));
  EXPECT_LT(rebound.state.velocity.head<2>().norm(), 1e-12);
  EXPECT_NEAR(result.max_penetration, 1e-3, 1e-6);
  const double expected = 0.5 * kPi * 1e-3 * (1.0 + 1.0 / std::sqrt(restitution));
  EXPECT_NEAR(rebound.contact_time, expected, 0.01 * expected);
  EXPECT_NEAR(result.energy.normal, 0.5 * (1.0 - restitution), 0.005);
  EXPECT_LT(result.energy.error, 0.01);
}
INSTANTIATE_TEST_SUITE_P(Restitutions, NormalImpact,
                         testing::Values(1.0, 0.64, 0.36, 0.25, 0.16, 0.04, 0.01));

// m v^2/2 against a law that unloads with a hundredth of the stiffness: below 1e8 N/m the block
// stays in and tends to m g/(k_n e_n^2), above it leaves again.
TEST(HeavyImpact, SoftGroundKeepsTheBlock) {
  const TerrainSurface terrain = ground(plane_mesh(20.0, 4));
  const RigidBody body = ball(1472.5, 1.5);
  const GroundParameters zone{0.01, 0.7, 0.0};
  RigidState start;
  start.position = {0.0, 0.0, 1.5001};
  start.velocity = {0.0, 0.0, -18.0};
  for (const double stiffness : {4e6, 1e7}) {
    ReleaseSettings settings = stiff_settings(body, stiffness);
    settings.max_time = 20.0;
    settings.rest_energy = 1e-12;
    ReleaseResult result;
    first_rebound(terrain, zone, body, start, settings, &result);
    const double depth = 1.5 - result.final_state.position.z();
    EXPECT_NEAR(depth, 1472.5 * 9.81 / (stiffness * 0.01), 0.02 * depth) << stiffness;
  }
  ReleaseSettings settings = stiff_settings(body, 1e8, 200.0);
  settings.max_time = 0.2;
  const Rebound rebound = first_rebound(terrain, zone, body, start, settings);
  ASSERT_TRUE(rebound.left);
  EXPECT_NEAR(rebound.state.velocity.z(), 1.377, 0.01);
}

// J = (1 + e) v / (1/m + (r x n).I^-1.(r x n)) for a single frictionless contact.
TEST(ObliqueBody, TiltedCubeImpulse) {
  const TerrainSurface terrain = ground(plane_mesh(5.0, 5));
  const RigidBody body = box(1000.0, Vec3::Ones());
  ReleaseSettings settings = stiff_settings(body, 1e11, 200.0);
  settings.gravity = 0.0;
  settings.max_time = 0.1;
  RigidState start;
  start.orientation = Quat(Eigen::AngleAxisd(kPi / 6.0, Vec3::UnitY()));
  start.position = {0.0, 0.0, 0.0};
  start.position.z() = 1e-4 - lowest_point(body, start);
  start.velocity = {0.0, 0.0, -5.0};
  const Rebound rebound = first_rebound(terrain, {0.01, 0.0, 0.0}, body, start, settings);
  ASSERT_TRUE(rebound.left);
  EXPECT_NEAR(rebound.state.velocity.z(), -0.4203, 0.01);
  EXPECT_NEAR(rebound.state.angular_velocity.norm(), 5.0288, 0.01);
  const double kept =
      translational_energy(body, rebound.state) + rotational_energy(body, rebound.state);
  EXPECT_NEAR(kept / 12500.0, 0.1757, 0.002);
}

// A sphere that meets the ground at 60 degrees: slides through with mu 0.3, rolls off with 0.7.
TEST(ObliqueSphere, SlidesOrSticks) {
  const TerrainSurface terrain = ground(plane_mesh(5.0, 5));
  const RigidBody body = ball(1.0, 0.1);
  ReleaseSettings settings = stiff_settings(body, 1e9, 400.0);
  settings.gravity = 0.0;
  settings.max_time = 0.02;
  RigidState start;
  start.position = {0.0, 0.0, 0.1001};
  start.velocity = {5.0 * std::sin(kPi / 3), 0.0, -5.0 * std::cos(kPi / 3)};
  const Rebound slides = first_rebound(terrain, {0.01, 0.3, 0.0}, body, start, settings);
  ASSERT_TRUE(slides.left);
  EXPECT_NEAR(slides.state.velocity.x(), 3.5051, 0.01);
  EXPECT_NEAR(0.1 * slides.state.angular_velocity.y(), 2.0625, 0.01);
  EXPECT_NEAR(slides.state.velocity.z(), 0.25, 0.005);
  // Stiff limit: a tangential spring that stores nothing worth mentioning.
  settings.stiffness.tangential = 1e12;
  settings.stiffness.time_step /= 20.0;
  const Rebound sticks = first_rebound(terrain, {0.01, 0.7, 0.0}, body, start, settings);
  ASSERT_TRUE(sticks.left);
  EXPECT_NEAR(sticks.state.velocity.x(), 3.0929, 0.03);
  EXPECT_NEAR(0.1 * sticks.state.angular_velocity.y(), 3.0929, 0.03);
}

// Edges inside a flat plane must not exist for a block.
TEST(GhostEdges, SpheresKeepTheirLine) {
  const RigidBody body = ball(485.0, 0.35);
  ReleaseSettings settings = stiff_settings(body, 1e8);
  settings.max_time = 1.0;
  Random random(11);
  for (const int cells : {1, 10, 100}) {
    const TerrainSurface terrain = ground(plane_mesh(5.0, cells));
    for (int i = 0; i < 40; ++i) {
      RigidState start;
      start.position = {random.uniform(-2, 2), random.uniform(-2, 2), 2.35};
      const ReleaseResult result = simulate_release(
          terrain, std::vector<GroundParameters>{{0.1, 0.0, 0.0}}, body, start, settings);
      EXPECT_LT(result.final_state.velocity.head<2>().norm(), 1e-6 * 6.26);
      EXPECT_EQ(result.final_state.angular_velocity.norm(), 0.0);
    }
  }
}

// A central impact returns e_n^2 of its energy however finely block and ground are cut.
TEST(MeshIndependence, FlatFaceImpact) {
  std::vector<double> kept, deepest;
  for (const int cuts : {1, 2, 4}) {
    for (const int cells : {1, 10, 100}) {
      const TerrainSurface terrain = ground(plane_mesh(5.0, cells));
      const RigidBody body = box(1000.0, Vec3::Ones(), 0.02, cuts);
      ReleaseSettings settings = stiff_settings(body, 1e8, 200.0);
      settings.gravity = 0.0;
      settings.max_time = 0.2;
      RigidState start;
      start.position = {0.1, 0.2, 0.53};
      start.velocity = {0.0, 0.0, -5.0};
      ReleaseResult result;
      const Rebound rebound =
          first_rebound(terrain, {0.1, 0.0, 0.0}, body, start, settings, &result);
      ASSERT_TRUE(rebound.left);
      kept.push_back(
          (translational_energy(body, rebound.state) + rotational_energy(body, rebound.state)) /
          12500.0);
      deepest.push_back(result.max_penetration);
    }
  }
  for (std::size_t i = 0; i < kept.size(); ++i) {
    EXPECT_NEAR(kept[i], 0.1, 0.001);
    EXPECT_NEAR(deepest[i], deepest[0], 1e-9);
  }
}

TEST(Start, InsideOrOffTheGroundIsRefused) {
  const TerrainSurface terrain = ground(plane_mesh(5.0, 5));
  const RigidBody body = ball(1.0, 0.1);
  const ReleaseSettings settings = stiff_settings(body, 1e6);
  const std::vector<GroundParameters> zones(1);
  RigidState start;
  start.position = {0.0, 0.0, 0.05};
  EXPECT_THROW(simulate_release(terrain, zones, body, start, settings), SimulationError);
  start.position = {0.0, 0.0, -3.0};
  EXPECT_THROW(simulate_release(terrain, zones, body, start, settings), SimulationError);
  start.position = {7.0, 0.0, 1.0};
  EXPECT_THROW(simulate_release(terrain, zones, body, start, settings), SimulationError);
}

}  // namespace
}  // namespace clast
