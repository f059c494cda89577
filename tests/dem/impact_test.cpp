// Single impacts and flights against closed forms.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/error.hpp"
#include "dem/contact/stiffness.hpp"
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

struct CentralImpact {
  double energy_restitution;
  ContactLaw law;
};
void PrintTo(const CentralImpact& impact, std::ostream* out) {
  *out << name_of(impact.law) << ", restitution " << impact.energy_restitution;
}

class NormalImpact : public testing::TestWithParam<CentralImpact> {};

// Without gravity: depth v sqrt(m/k), loading for a quarter period, unloading 1/e_n times that.
TEST_P(NormalImpact, ReturnsTheAskedRestitution) {
  const auto& [energy_restitution, law] = GetParam();
  const double restitution = std::sqrt(energy_restitution);
  const TerrainSurface terrain = ground(plane_mesh(1.0, 6));
  const RigidBody body = ball(1.0, 0.1);
  const bool yields = std::holds_alternative<ElastoplasticLaw>(law);
  ReleaseSettings settings = stiff_settings(body, 1e6, yields ? 50.0 / restitution : 50.0);
  settings.law = law;
  settings.gravity = 0.0;
  settings.max_time = 0.3;
  RigidState start;
  start.position = {0.05, 0.02, 0.15};
  start.velocity = {0.0, 0.0, -1.0};
  ReboundWatch watch{body, {}};
  double peak = 0.0;
  const ReleaseResult result =
      simulate_release(terrain, std::vector<GroundParameters>{{energy_restitution, 0.5, 0.0}}, body,
                       start, settings, [&](const MotionStep& step) {
                         watch(step);
                         if (step.flight) return;
                         const double force = (step.end.velocity.z() - step.begin.velocity.z()) /
                                              (step.end_time - step.begin_time);
                         peak = std::max(peak, force);
                       });
  const Rebound& rebound = watch.rebound;
  ASSERT_TRUE(rebound.left);
  EXPECT_NEAR(rebound.state.velocity.z(), restitution, 0.005 * restitution);
  EXPECT_LT(rebound.state.velocity.head<2>().norm(), 1e-12);
  EXPECT_NEAR(result.energy.normal, 0.5 * (1.0 - energy_restitution), 0.0005);
  EXPECT_LT(result.energy.error, 1e-3);
  if (std::holds_alternative<SpringDashpotLaw>(law)) return;
  EXPECT_NEAR(result.max_penetration, 1e-3, 1e-6);
  EXPECT_NEAR(peak, 1000.0, 2.0);
  if (yields) return;  // touches without load while it leaves its dent
  const double duration = 0.5 * kPi * 1e-3 * (1.0 + 1.0 / restitution);
  EXPECT_NEAR(rebound.contact_time, duration, 0.001 * duration + settings.stiffness.time_step);
}
std::vector<CentralImpact> impacts() {
  std::vector<CentralImpact> all;
  for (const double e : {1.0, 0.64, 0.36, 0.25, 0.16, 0.04, 0.01}) {
    all.push_back({e, EnergyRestitutionLaw()});
    all.push_back({e, SpringDashpotLaw()});
    all.push_back({e, ElastoplasticLaw()});
  }
  return all;
}
INSTANTIATE_TEST_SUITE_P(Restitutions, NormalImpact, testing::ValuesIn(impacts()),
                         [](const auto& test) {
                           std::string name = name_of(test.param.law);
                           name.erase(std::remove(name.begin(), name.end(), '-'), name.end());
                           const double percent = 100.0 * test.param.energy_restitution;
                           return name + "_" + std::to_string(std::lround(percent)) + "_percent";
                         });

/// 1472.5 kg at 18 m/s against a law that unloads with a hundredth of the stiffness.
struct HeavyImpact : testing::Test {
  TerrainSurface terrain = ground(plane_mesh(20.0, 4));
  RigidBody body = ball(1472.5, 1.5);
  GroundParameters zone{0.01, 0.7, 0.0};
  RigidState start;
  void SetUp() override {
    start.position = {0.0, 0.0, 1.5};
    start.velocity = {0.0, 0.0, -18.0};
  }
  double depth_after(double time, double stiffness) {
    ReleaseSettings settings = stiff_settings(body, stiffness);
    settings.max_time = time;
    settings.rest_energy = 1e-12;
    const ReleaseResult result =
        simulate_release(terrain, std::span(&zone, 1), body, start, settings);
    return 1.5 - result.final_state.position.z();
  }
};

TEST_F(HeavyImpact, SoftGroundKeepsTheBlock) {
  EXPECT_NEAR(depth_after(1.0, 1e6), 0.814, 0.02 * 0.814);
  EXPECT_NEAR(depth_after(20.0, 1e6), 1.418, 0.02 * 1.418);
  EXPECT_NEAR(depth_after(60.0, 1e6), 1.4445, 0.02 * 1.4445);
  EXPECT_NEAR(depth_after(30.0, 2e6), 0.7223, 0.02 * 0.7223);
  EXPECT_NEAR(depth_after(20.0, 4e6), 0.3611, 0.02 * 0.3611);
  EXPECT_NEAR(depth_after(20.0, 1e7), 0.1445, 0.02 * 0.1445);
}

TEST_F(HeavyImpact, HardGroundLetsItGo) {
  ReleaseSettings settings = stiff_settings(body, 1e8, 50.0);
  settings.max_time = 0.2;
  const Rebound rebound = first_rebound(terrain, zone, body, start, settings);
  ASSERT_TRUE(rebound.left);
  EXPECT_NEAR(rebound.state.velocity.z(), 1.377, 0.002);
}

TEST_F(HeavyImpact, AutoNeverSettlesDeeperThanItsLimit) {
  ReleaseSettings settings;
  settings.stiffness =
      choose_stiffness(std::span(&body, 1), std::span(&zone, 1), 18.0, 9.81).stiffness;
  const ReleaseResult result =
      simulate_release(terrain, std::span(&zone, 1), body, start, settings);
  EXPECT_EQ(result.stop_reason, StopReason::kRest);
  EXPECT_LE(result.settled_penetration, 0.02 * 1.001);
}

// J = (1 + e) v / (1/m + (r x n).I^-1.(r x n)) for a single frictionless contact.
TEST(ObliqueBody, TiltedCubeImpulse) {
  const TerrainSurface terrain = ground(plane_mesh(5.0, 5));
  const RigidBody body = box(1000.0, Vec3::Ones());
  ReleaseSettings settings = stiff_settings(body, 1e13, 50.0);
  settings.gravity = 0.0;
  settings.max_time = 0.01;
  RigidState start;
  start.orientation = Quat(Eigen::AngleAxisd(kPi / 6.0, Vec3::UnitY()));
  start.position = {0.0, 0.0, 0.0};
  start.position.z() = 1e-4 - lowest_height(body, start);
  start.velocity = {0.0, 0.0, -5.0};
  const Rebound rebound = first_rebound(terrain, {0.01, 0.0, 0.0}, body, start, settings);
  ASSERT_TRUE(rebound.left);
  EXPECT_NEAR(1000.0 * (rebound.state.velocity.z() + 5.0), 4579.7, 2.0);
  EXPECT_NEAR(rebound.state.velocity.z(), -0.4203, 0.002);
  EXPECT_NEAR(rebound.state.angular_velocity.norm(), 5.0288, 0.002);
  const double kept =
      translational_energy(body, rebound.state) + rotational_energy(body, rebound.state);
  EXPECT_NEAR(kept / 12500.0, 0.1757, 0.0003);
}

TEST(ObliqueBody, ImpulseOfRandomBlocks) {
  const TerrainSurface terrain = ground(plane_mesh(5.0, 5));
  constexpr double kRestitution = 0.5;
  int compared = 0;
  for (std::uint64_t seed = 1; compared < 200; ++seed) {
    Random random(seed);
    const Vec3 sides(random.uniform(0.5, 1.2), random.uniform(0.5, 1.2), random.uniform(0.5, 1.2));
    const double radius = 0.01;
    const RigidBody body = box(random.uniform(200.0, 2000.0), sides, radius);
    RigidState start;
    start.orientation = random.rotation();
    // One corner well below the others, so that it alone touches.
    std::vector<std::pair<double, Vec3>> corners;
    for (const Vec3& vertex : body.shape.vertices) {
      const Vec3 placed = start.orientation * vertex;
      corners.emplace_back(placed.z(), placed);
    }
    std::sort(corners.begin(), corners.end(),
              [](const auto& a, const auto& b) { return a.first < b.first; });
    if (corners[1].first - corners[0].first < 0.05) continue;
    ++compared;
    start.position.z() = 1e-4 - lowest_height(body, start);
    start.velocity = {random.uniform(-2.0, 2.0), random.uniform(-2.0, 2.0), -5.0};
    ReleaseSettings settings = stiff_settings(body, 1e11, 50.0);
    settings.gravity = 0.0;
    settings.max_time = 2e-5 + 4.0 * kPi * std::sqrt(body.mass / 1e11);
    const Rebound rebound =
        first_rebound(terrain, {kRestitution * kRestitution, 0.0, 0.0}, body, start, settings);
    ASSERT_TRUE(rebound.left) << seed;
    const Vec3 arm = corners[0].second - radius * Vec3::UnitZ();
    const Vec3 torque = start.orientation.conjugate() * arm.cross(Vec3::UnitZ());
    const double mobility = 1.0 / body.mass + torque.dot(torque.cwiseQuotient(body.moments));
    const double expected = (1.0 + kRestitution) * 5.0 / mobility;
    EXPECT_NEAR(body.mass * (rebound.state.velocity.z() + 5.0), expected, 0.01 * expected) << seed;
  }
}

// A sphere that hits the ground at 60 degrees: slides through with mu 0.3, rolls off with 0.7.
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
