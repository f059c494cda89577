// Ground that yields under whole blocks: what they keep of their energy, and where they rest.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "dem/contact/stiffness.hpp"
#include "tests/support/gravity.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/test_worlds.hpp"

namespace clast {
namespace {

/// @param per_radian  steps per radian of the loading; unloading is 1/e_n as fast
ReleaseSettings yielding_settings(const RigidBody& body, double stiffness,
                                  double energy_restitution, double per_radian = 20.0) {
  ReleaseSettings settings =
      stiff_settings(body, stiffness, per_radian / std::sqrt(energy_restitution));
  settings.law = ElastoplasticLaw();
  return settings;
}

struct Drop {
  int ground_cells, block_cuts;
  double energy_restitution;
};
void PrintTo(const Drop& drop, std::ostream* out) {
  *out << drop.ground_cells << " cells, " << drop.block_cuts << " cuts, e_n^2 "
       << drop.energy_restitution;
}

class FlatDrop : public testing::TestWithParam<Drop> {};

// A box that falls flat, without gravity: (1 - e_n^2) m v^2/2 goes into the dent, however many
// points and triangles share the contact.
TEST_P(FlatDrop, ReturnsTheAskedRestitutionOnAnySubdivision) {
  const auto& [cells, cuts, e] = GetParam();
  const TerrainSurface terrain = ground(plane_mesh(2.0, cells));
  const RigidBody body = box(1000.0, {1.0, 0.8, 0.6}, 0.0, cuts);
  ReleaseSettings settings = yielding_settings(body, 1e7, e);
  settings.gravity = 0.0;
  settings.max_time = 0.5;
  RigidState start;
  start.position = {0.07, 0.05, 0.31};
  start.velocity.z() = -2.0;
  const ReleaseResult result = simulate_release(
      terrain, std::vector<GroundParameters>{{e, 0.5, 0.0}}, body, start, settings);
  const double kept = translational_energy(body, result.final_state) / 2000.0;
  EXPECT_NEAR(kept, e, 0.01 * e);
  EXPECT_NEAR(result.energy.normal, 2000.0 * (1.0 - e), 0.01 * 2000.0 * e);
  EXPECT_NEAR(result.max_penetration, 2.0 * std::sqrt(1000.0 / 1e7), 1e-5);
  EXPECT_LT(result.energy.error, 1e-3);
}
INSTANTIATE_TEST_SUITE_P(Subdivisions, FlatDrop,
                         testing::Values(Drop{1, 1, 0.04}, Drop{16, 1, 0.04}, Drop{1, 5, 0.04},
                                         Drop{16, 5, 0.04}, Drop{16, 5, 0.25}, Drop{3, 2, 0.01}));

/// Height of the centre of a ball of 1000 kg and 0.5 m at rest on ground of 1e7 N/m, above that at
/// which it touches.
double rest_height(double energy_restitution, double drop, ReleaseResult& result) {
  const TerrainSurface terrain = ground(plane_mesh(5.0, 6));
  const RigidBody body = ball(1000.0, 0.5);
  ReleaseSettings settings = yielding_settings(body, 1e7, energy_restitution);
  settings.start_overlap = 1.0;
  settings.max_time = 30.0;
  RigidState start;
  start.position.z() = 0.5 + drop;
  result = simulate_release(terrain, std::vector<GroundParameters>{{energy_restitution, 0.5, 0.0}},
                            body, start, settings);
  return result.final_state.position.z() - 0.5;
}

// Put down without speed, the weight overshoots to twice its static depth and stays in that dent.
TEST(YieldingGround, CarriesABlockBetweenItsDentAndItsStaticDepth) {
  const double weight = 1000.0 * kTestGravity, deepest = 2.0 * weight / 1e7;
  for (const double e : {0.01, 0.1}) {
    ReleaseResult result;
    const double height = rest_height(e, 0.0, result);
    EXPECT_EQ(result.stop_reason, StopReason::kRest);
    const double residual_indentation = deepest * (1.0 - e);
    // Above its dent by what carries it when it loads again, or unloads.
    EXPECT_LE(-height, residual_indentation + weight * e / 1e7 + 1e-6) << e;
    EXPECT_GE(-height, residual_indentation + 0.5 * weight * e / 1e7 - 1e-6) << e;
    EXPECT_FALSE(result.below_ground);
    EXPECT_LT(result.energy.error, 1e-3);
  }
}

// The dent of a fall stays, h = (W + (W^2 + 2 k W H)^(1/2))/k, where the default law would have the
// block sink to m g/(k e_n^2) = 9.8 cm.
TEST(YieldingGround, KeepsTheDentOfAFall) {
  ReleaseResult result;
  const double height = rest_height(0.01, 0.2, result);
  const double weight = 1000.0 * kTestGravity;
  const double deepest = (weight + std::sqrt(weight * weight + 2.0 * 1e7 * weight * 0.2)) / 1e7;
  EXPECT_EQ(result.stop_reason, StopReason::kRest);
  EXPECT_NEAR(result.max_penetration, deepest, 1e-4 * deepest);
  EXPECT_NEAR(-height, 0.99 * deepest + 0.01 * weight / 1e7, 1e-4);
  EXPECT_FALSE(result.below_ground);
}

// A minute on a slope just flatter than its friction angle; on one just steeper it slides.
TEST(YieldingGround, HoldsBelowTheFrictionAngleAndDoesNotCreep) {
  for (const double degrees : {-0.3, 0.3}) {
    const double slope = std::atan(0.7) + degrees * kPi / 180.0;
    const TerrainSurface terrain = ground(plane_mesh(40.0, 20, slope));
    const RigidBody body = box(1000.0, {1.0, 1.0, 0.2});
    ReleaseSettings settings = yielding_settings(body, 1e7, 0.04, 5.0);
    settings.rest_energy = 1e-300;
    settings.max_time = degrees < 0.0 ? 62.0 : 12.0;
    const Vec3 normal(std::sin(slope), 0.0, std::cos(slope));
    RigidState start;
    start.orientation = Quat(Eigen::AngleAxisd(slope, Vec3::UnitY()));
    start.position = (0.1 + 1e-6) * normal;
    Vec3 early = Vec3::Zero();
    double farthest = 0.0;
    const auto watch = [&](const MotionStep& step) {
      const bool settled = step.end_time >= 2.0;
      if (!settled) early = step.end.position;
      farthest = settled ? std::max(farthest, (step.end.position - early).norm()) : 0.0;
    };
    simulate_release(terrain, std::vector<GroundParameters>{{0.04, 0.7, 0.0}}, body, start,
                     settings, watch);
    if (degrees < 0.0) {
      EXPECT_LT(farthest, 1e-4);
    } else {
      EXPECT_GT(farthest, 0.5);
    }
  }
}

// A box that slides onto ground that unloads otherwise keeps its load: it neither sinks nor gains.
TEST(YieldingGround, KeepsTheLoadFromZoneToZone) {
  TriangleMesh mesh = plane_mesh(10.0, 30);
  std::vector<std::uint16_t> zones;
  for (const TriangleMesh::Triangle& triangle : mesh.triangles) {
    double x = 0.0;
    for (const std::uint32_t vertex : triangle) x += mesh.vertices[vertex].x() / 3.0;
    zones.push_back(x > 0.0 ? 1 : 0);
  }
  const TerrainSurface terrain(std::move(mesh), std::move(zones));
  const RigidBody body = box(1000.0, {1.0, 0.8, 0.2});
  for (const bool onto_stiffer : {true, false}) {
    const std::vector<GroundParameters> ground = {{onto_stiffer ? 0.25 : 0.01, 0.3, 0.0},
                                                  {onto_stiffer ? 0.01 : 0.25, 0.3, 0.0}};
    ReleaseSettings settings = yielding_settings(body, 1e7, 0.01, 10.0);
    settings.stiffness.tangential = 1e9;
    settings.max_time = 5.0;
    RigidState start;
    start.position = {-2.0, 0.1, 0.1 + 1e-6};
    start.velocity.x() = 5.0;
    double least = 1.0, most = 0.0;
    const ReleaseResult result =
        simulate_release(terrain, ground, body, start, settings, [&](const MotionStep& step) {
          if (step.end_time < 0.2) return;
          least = std::min(least, 0.1 - step.end.position.z());
          most = std::max(most, 0.1 - step.end.position.z());
        });
    EXPECT_EQ(result.stop_reason, StopReason::kRest);
    EXPECT_GT(result.final_state.position.x(), 0.6);
    EXPECT_LT(most - least, 0.1 * 1000.0 * kTestGravity / 1e7);
    EXPECT_GT(result.energy.reassigned, -1e-3 * result.energy.friction);
    EXPECT_LT(result.energy.error, 1e-3);
  }
}

// Rocks that tumble down a rough slope come to rest with every joule accounted for.
TEST(YieldingGround, TakesRocksToRest) {
  const TerrainSurface terrain = ground(rough_slope(80, 0.5, 0.35, 0.10));
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    const RigidBody body = rock(4, {0.45, 0.33, 0.28}, 0.01, 2650.0, seed);
    const std::vector<GroundParameters> zones = {{0.04, 0.7, 0.3}};
    ReleaseSettings settings;
    settings.law = ElastoplasticLaw();
    StiffnessOptions options;
    options.law = settings.law;
    settings.stiffness =
        choose_stiffness(std::span(&body, 1), zones, 12.0, kTestGravity, options).stiffness;
    RigidState start;
    start.orientation = Random(seed).rotation();
    start.position = {-5.0, 0.0, 5.0 * std::tan(0.35) + 2.0};
    const ReleaseResult result = simulate_release(terrain, zones, body, start, settings);
    EXPECT_EQ(result.stop_reason, StopReason::kRest) << seed;
    EXPECT_FALSE(result.below_ground);
    EXPECT_LT(result.energy.error, 0.005);
  }
}

// Two balls of a world that meet head on share the dent between them.
TEST(YieldingGround, IsTheSameBetweenBodies) {
  const RigidBody body = ball(2.0, 0.1);
  WorldSettings settings = stiff_world(body, 1e6, 200.0);
  settings.law = ElastoplasticLaw();
  settings.between_bodies = {0.16, 0.3, 0.0};
  World world({body}, settings);
  world.add_body(0, at({-0.11, 0.0, 0.0}, {1.0, 0.0, 0.0}));
  world.add_body(0, at({0.11, 0.0, 0.0}, {-1.0, 0.0, 0.0}));
  world.run_until_rest(0.1);
  EXPECT_NEAR(world.state(0).velocity.x(), -0.4, 0.004);
  EXPECT_NEAR(world.state(1).velocity.x(), 0.4, 0.004);
  EXPECT_NEAR(world.linear_momentum().norm(), 0.0, 1e-12);
  EXPECT_NEAR(world.energy_balance().normal, 2.0 * (1.0 - 0.16), 0.01);
  EXPECT_LT(world.energy_balance().error, 1e-3);
}

// k_n is what a fast impact needs, and the dent of that may stay; unloading sets the steps.
TEST(YieldingGround, GetsItsStiffnessFromImpactsAndItsStepsFromUnloading) {
  const RigidBody body = ball(1000.0, 0.5);
  const std::vector<GroundParameters> zones = {{0.04, 0.7, 0.0}};
  StiffnessOptions options;
  options.law = ElastoplasticLaw();
  options.rolling = 1.0;
  const StiffnessChoice choice =
      choose_stiffness(std::span(&body, 1), zones, 20.0, kTestGravity, options);
  const double k = choice.stiffness.normal;
  EXPECT_NEAR(k, 1000.0 * 400.0 / (0.25 * 0.25), 1.0);
  EXPECT_NEAR(choice.stiffness.tangential, k / 0.04, 1.0);
  EXPECT_NEAR(choice.settled_depth, 0.96 * choice.impact_depth, 1e-12);
  const double fastest = std::sqrt(2.0 / 0.04 * k / 1000.0 * 3.5);
  EXPECT_NEAR(choice.stiffness.time_step, 0.2 / fastest, 1e-12);
  EXPECT_TRUE(choice.warnings.empty());
  const std::vector<GroundParameters> dear = {{1e-6, 0.7, 0.0}};
  const auto warnings =
      choose_stiffness(std::span(&body, 1), dear, 20.0, kTestGravity, options).warnings;
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_TRUE(contains(warnings[0], "energy_restitution = 1e-06")) << warnings[0];
  EXPECT_TRUE(contains(warnings[0], "100 times the work")) << warnings[0];
}

}  // namespace
}  // namespace clast
