// How stiffness is shared among contact points, and how it is chosen.
#include <gtest/gtest.h>

#include <cmath>

#include "core/error.hpp"
#include "dem/contact/stiffness.hpp"
#include "tests/support/gravity.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/test_rock.hpp"

namespace clast {
namespace {

/// A bridge of 1000 kg on two feet, 1.2 m of air between them.
RigidBody bridge() {
  const std::array<Vec2, 8> profile = {Vec2(-1, 0),  Vec2(-0.6, 0), Vec2(-0.6, 0.3), Vec2(0.6, 0.3),
                                       Vec2(0.6, 0), Vec2(1, 0),    Vec2(1, 0.6),    Vec2(-1, 0.6)};
  const std::array<std::array<std::uint32_t, 3>, 6> cap = {
      {{0, 1, 2}, {0, 2, 7}, {2, 3, 6}, {2, 6, 7}, {3, 4, 5}, {3, 5, 6}}};
  TriangleMesh mesh;
  for (const double y : {-0.5, 0.5}) {
    for (const Vec2& p : profile) mesh.vertices.emplace_back(p.x(), y, p.y() - 0.35);
  }
  for (const auto& [a, b, c] : cap) {
    mesh.triangles.push_back({a, b, c});
    mesh.triangles.push_back({a + 8, c + 8, b + 8});
  }
  for (std::uint32_t i = 0; i < 8; ++i) {
    const std::uint32_t j = (i + 1) % 8;
    mesh.triangles.push_back({i, i + 8, j + 8});
    mesh.triangles.push_back({i, j + 8, j});
  }
  RigidBody body;
  body.shape = make_sphero_polyhedron(mesh, 0.0);
  body.mass = 1000.0;
  body.moments = {150.0, 400.0, 400.0};
  body.smallest_side = 0.6;
  return body;
}

struct Sharing {
  ContactWeighting weighting;
  double laws;  ///< how many times the full stiffness carries the bridge
};
void PrintTo(const Sharing& sharing, std::ostream* out) { *out << name_of(sharing.weighting); }

class RestDepth : public testing::TestWithParam<Sharing> {};

// Each foot has four corners: one law per patch, per body, per body, or per point.
TEST_P(RestDepth, IsThatOfTheLawsThatCarryTheBlock) {
  const auto [weights, laws] = GetParam();
  const TerrainSurface terrain = ground(plane_mesh(5.0, 12));
  const RigidBody body = bridge();
  ReleaseSettings settings = stiff_settings(body, 1e8);
  settings.weighting = weights;
  settings.start_overlap = 1.0;
  settings.max_time = 0.3;
  settings.rest_energy = 1e-300;
  const double depth = 1000.0 * kTestGravity / (laws * 1e8 * 0.04);
  RigidState start;
  start.position = {0.1, 0.2, 0.35 - depth};
  const ReleaseResult result = simulate_release(
      terrain, std::vector<GroundParameters>{{0.04, 0.5, 0.0}}, body, start, settings);
  EXPECT_NEAR(0.35 - result.final_state.position.z(), depth, 0.01 * depth);
  EXPECT_LT(result.final_state.orientation.angularDistance(Quat::Identity()), 1e-6);
}
INSTANTIATE_TEST_SUITE_P(Weights, RestDepth,
                         testing::Values(Sharing{ContactWeighting::kPatch, 2.0},
                                         Sharing{ContactWeighting::kOverlap, 1.0},
                                         Sharing{ContactWeighting::kCount, 1.0},
                                         Sharing{ContactWeighting::kNone, 8.0}),
                         [](const auto& test) { return name_of(test.param.weighting); });

// Many small drops on flat ground: whatever way a block settles, it is not below ground.
TEST(Settling, IsNeverTakenForSinking) {
  const TerrainSurface terrain = ground(plane_mesh(20.0, 20));
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    const RigidBody body = rock(3, {0.25, 0.20, 0.15}, 0.006, 2650.0, seed);
    const std::vector<GroundParameters> zones = {{0.01, 0.9, 0.6}};
    ReleaseSettings settings;
    settings.stiffness = choose_stiffness(std::span(&body, 1), zones, 3.0, kTestGravity).stiffness;
    RigidState start;
    start.orientation = Random(seed).rotation();
    start.position.z() = 0.2 - lowest_height(body, start);
    const ReleaseResult result = simulate_release(terrain, zones, body, start, settings);
    EXPECT_EQ(result.stop_reason, StopReason::kRest);
    EXPECT_FALSE(result.below_ground) << seed << ": " << result.settled_penetration;
  }
}

class AnyWeights : public testing::TestWithParam<ContactWeighting> {};

TEST_P(AnyWeights, RocksComeToRestWithTheirEnergyAccountedFor) {
  const TerrainSurface terrain = ground(rough_slope(80, 0.5, 0.45, 0.10));
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    const RigidBody body = rock(4, {0.45, 0.33, 0.28}, 0.01, 2650.0, seed);
    const std::vector<GroundParameters> zones = {{0.01, 0.7, 0.3}};
    ReleaseSettings settings;
    settings.weighting = GetParam();
    settings.stiffness = choose_stiffness(std::span(&body, 1), zones, 15.0, kTestGravity).stiffness;
    RigidState start;
    start.orientation = Random(seed).rotation();
    start.position = {-5.0, 0.0, 5.0 * std::tan(0.45) + 2.0};
    const ReleaseResult result = simulate_release(terrain, zones, body, start, settings);
    EXPECT_EQ(result.stop_reason, StopReason::kRest);
    EXPECT_FALSE(result.below_ground);
    EXPECT_LT(result.energy.error, 0.005);
  }
}
INSTANTIATE_TEST_SUITE_P(Weights, AnyWeights,
                         testing::Values(ContactWeighting::kPatch, ContactWeighting::kOverlap,
                                         ContactWeighting::kCount, ContactWeighting::kNone),
                         [](const auto& test) { return name_of(test.param); });

TEST(Weights, NamesGoBothWays) {
  for (const char* name : {"patch", "overlap", "count", "none"}) {
    EXPECT_EQ(name_of(parse_contact_weighting(name)), name);
  }
  EXPECT_THROW(parse_contact_weighting("fair"), InputError);
}

TEST(AutoStiffness, RestsWithinTwoPercentOfTheShortestSide) {
  const std::vector<RigidBody> bodies = {box(1000.0, {1.0, 0.8, 0.5}), box(400.0, {3.0, 2.0, 1.5})};
  const std::vector<GroundParameters> zones = {{0.25, 0.7, 0.0}, {0.01, 0.7, 0.0}};
  const StiffnessChoice choice = choose_stiffness(bodies, zones, 1.0, kTestGravity);
  // The first body governs: 2 % of 0.5 m; the second may sink 2 cm.
  EXPECT_NEAR(choice.stiffness.normal, 1000.0 * kTestGravity / (0.01 * 0.01), 1.0);
  EXPECT_NEAR(choice.settled_depth, 0.01, 1e-12);
  EXPECT_TRUE(choice.warnings.empty());
}

// Its spring alone carries at rest, and an overdamped contact is faster than its spring.
TEST(AutoStiffness, SpringDashpotRestsOnItsSpring) {
  const RigidBody body = ball(1000.0, 0.5);
  const std::vector<GroundParameters> zones = {{0.01, 0.7, 0.0}};
  StiffnessOptions options;
  options.law = SpringDashpotLaw();
  options.rolling = 1.0;
  const StiffnessChoice choice =
      choose_stiffness(std::span(&body, 1), zones, 1.0, kTestGravity, options);
  EXPECT_NEAR(choice.stiffness.normal, 1000.0 * kTestGravity / 0.02, 1.0);
  const double ratio = damping_ratio_for_restitution(0.01);
  const double rate = (ratio + std::sqrt(ratio * ratio - 1.0)) *
                      std::sqrt(choice.stiffness.normal / 1000.0 * (1.0 + 2.5));
  EXPECT_NEAR(choice.stiffness.time_step, 0.2 / rate, 1e-3 * 0.2 / rate);
  EXPECT_NEAR(choice.stiffness.max_time_step, 0.4 / rate, 1e-3 * 0.4 / rate);

  ReleaseSettings settings;
  settings.stiffness = choice.stiffness;
  settings.law = options.law;
  const TerrainSurface terrain = ground(plane_mesh(5.0, 6));
  RigidState start;
  start.position.z() = 0.6;
  const ReleaseResult result = simulate_release(terrain, zones, body, start, settings);
  EXPECT_EQ(result.stop_reason, StopReason::kRest);
  EXPECT_NEAR(result.settled_penetration, 0.02, 1e-4);
  EXPECT_FALSE(result.below_ground);
}

TEST(AutoStiffness, FastImpactsStayWithinAQuarterOfTheShortestSide) {
  const RigidBody body = box(1000.0, Vec3::Ones());
  const std::vector<GroundParameters> zones = {{1.0, 0.7, 0.0}};
  const StiffnessChoice choice = choose_stiffness(std::span(&body, 1), zones, 40.0, kTestGravity);
  // A quarter of S, and the little that the weight adds: m v^2/2 + m g h = k h^2/2.
  const double k = choice.stiffness.normal, weight = 1000.0 * kTestGravity;
  EXPECT_NEAR(choice.impact_depth,
              (weight + std::sqrt(weight * weight + k * 1000.0 * 40.0 * 40.0)) / k, 1e-12);
  EXPECT_NEAR(choice.impact_depth, 0.25, 1e-3);
  EXPECT_NEAR(choice.stiffness.normal, 1000.0 * 40.0 * 40.0 / (0.25 * 0.25), 1.0);
}

TEST(AutoStiffness, AStepThatMakesEnergyOrPassesTheGroundIsRefused) {
  const RigidBody body = box(1000.0, Vec3::Ones());
  const std::vector<GroundParameters> zones = {{0.01, 0.7, 0.0}};
  const auto refused = [&](double normal, double step) {
    StiffnessOptions options;
    options.normal = normal;
    options.time_step = step;
    return refusal<SimulationError>(
        [&] { choose_stiffness(std::span(&body, 1), zones, 10.0, kTestGravity, options); });
  };
  // Stable below 2 / sqrt(k (1/m)(1 + 3/4 * 6)) = 6.0e-3 s.
  EXPECT_TRUE(contains(refused(2e7, 0.05), "time step 0.05 s is too long: beyond 0.00603 s"));
  EXPECT_EQ(refused(2e7, 0.005), "");
  // A quarter of S at 10 m/s.
  EXPECT_TRUE(contains(refused(10.0, 0.1), "beyond 0.025 s"));
  StiffnessOptions soft;
  soft.normal = 10.0;
  EXPECT_EQ(
      choose_stiffness(std::span(&body, 1), zones, 10.0, kTestGravity, soft).stiffness.time_step,
      0.025);
}

TEST(AutoStiffness, HardlyAnyRestitutionIsDearAndSaysSo) {
  const RigidBody body = box(1000.0, Vec3::Ones());
  const auto warnings = [&](double energy_restitution) {
    const std::vector<GroundParameters> zones = {{energy_restitution, 0.7, 0.0}};
    return choose_stiffness(std::span(&body, 1), zones, 1.0, kTestGravity).warnings;
  };
  EXPECT_TRUE(warnings(0.01).empty());
  ASSERT_EQ(warnings(1e-6).size(), 1u);
  EXPECT_TRUE(contains(warnings(1e-6)[0], "energy_restitution = 1e-06"));
  EXPECT_TRUE(contains(warnings(1e-6)[0], "k_n = 4.9e+11 N/m")) << warnings(1e-6)[0];
  EXPECT_TRUE(contains(warnings(1e-6)[0], "100 times the work")) << warnings(1e-6)[0];
}

TEST(AutoStiffness, ASofterValueIsObeyedWithAWarning) {
  const RigidBody body = box(1000.0, Vec3::Ones());
  const std::vector<GroundParameters> zones = {{0.01, 0.7, 0.0}};
  StiffnessOptions options;
  options.normal = 2e6;
  const StiffnessChoice choice =
      choose_stiffness(std::span(&body, 1), zones, 10.0, kTestGravity, options);
  EXPECT_EQ(choice.stiffness.normal, 2e6);
  ASSERT_EQ(choice.warnings.size(), 1u);
  EXPECT_NE(choice.warnings[0].find("0.49 m deep"), std::string::npos) << choice.warnings[0];
}

// The steps resolve the fastest contact a body can have: a cube's corner moves under a force as a
// mass of m / (1 + r^2 m / J) with r^2 = 3/4 and J = m/6.
TEST(AutoStiffness, TimeStepFollowsTheLightestPoint) {
  const RigidBody body = box(1000.0, Vec3::Ones());
  const std::vector<GroundParameters> zones = {{0.01, 0.7, 0.0}};
  StiffnessOptions options;
  options.normal = 1e8;
  options.rolling = 1.0;
  const StiffnessChoice choice =
      choose_stiffness(std::span(&body, 1), zones, 10.0, kTestGravity, options);
  const double point_mass = 1000.0 / (1.0 + 0.75 * 6.0);
  EXPECT_NEAR(choice.stiffness.time_step, 0.2 * std::sqrt(point_mass / 1e8), 1e-11);
  EXPECT_NEAR(choice.stiffness.max_time_step, 0.4 * std::sqrt(point_mass / 1e8), 1e-11);
  options.multi_block = true;
  const ContactStiffness of_mass =
      choose_stiffness(std::span(&body, 1), zones, 10.0, kTestGravity, options).stiffness;
  EXPECT_EQ(of_mass.time_step, choice.stiffness.max_time_step);
  EXPECT_EQ(of_mass.max_time_step, choice.stiffness.max_time_step);
}

}  // namespace
}  // namespace clast
