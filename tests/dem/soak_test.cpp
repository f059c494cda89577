// Thousands of fast concave blocks on rough ground: nothing is lost and every joule is found again.
#include <gtest/gtest.h>

#include <algorithm>

#include "core/parallel.hpp"
#include "dem/contact/stiffness.hpp"
#include "tests/support/test_rock.hpp"

namespace clast {
namespace {

struct Outcome {
  ReleaseResult result;
  double reassigned = 0.0;  ///< share of what is dissipated
};

Outcome release(const TerrainSurface& terrain, std::uint64_t seed, bool soft) {
  Random random(seed);
  const Vec3 half(random.uniform(0.3, 0.6), random.uniform(0.2, 0.4), random.uniform(0.15, 0.3));
  const RigidBody body = rock(3 + static_cast<int>(seed % 3), half, seed % 2 == 0 ? 0.02 : 0.01,
                              2650.0, 50 + seed % 20);
  const std::vector<GroundParameters> zones = {
      {0.01, random.uniform(0.3, 0.8), random.uniform(0.0, 0.4)}};
  StiffnessOptions options;
  if (soft) options.normal = body.mass * 9.81 / (0.01 * 0.25 * body.smallest_side);
  ReleaseSettings settings;
  settings.stiffness = choose_stiffness(std::span(&body, 1), zones, 45.0, 9.81, options).stiffness;
  RigidState start;
  start.orientation = random.rotation();
  start.position = {random.uniform(-20.0, 0.0), random.uniform(-15.0, 15.0), 0.0};
  start.position.z() =
      *terrain.height_at(start.position.x(), start.position.y(), 0.0) + random.uniform(1.5, 4.0);
  start.velocity = random.uniform(0.0, 40.0) * random.unit_vector();
  start.angular_velocity = random.uniform(0.0, 20.0) * random.unit_vector();
  Outcome outcome{simulate_release(terrain, zones, body, start, settings)};
  const EnergyBalance& energy = outcome.result.energy;
  if (energy.dissipated() > 0.0) outcome.reassigned = energy.reassigned / energy.dissipated();
  return outcome;
}

class Soak : public testing::TestWithParam<bool> {};

TEST_P(Soak, NoBlockIsLostAndTheEnergyBalances) {
  const TerrainSurface terrain = ground(rough_slope(120, 0.5, 0.6, 0.15, 7));
  constexpr std::size_t kReleases = 1000;
  std::vector<double> reassigned(kReleases);
  parallel_for(kReleases, 0, [&](std::size_t i) {
    const auto [result, share] = release(terrain, 1000 + i, GetParam());
    EXPECT_NE(result.stop_reason, StopReason::kError) << i << ": " << result.message;
    EXPECT_NE(result.stop_reason, StopReason::kMaxTime) << i;
    EXPECT_FALSE(result.below_ground) << i;
    EXPECT_TRUE(result.final_state.position.allFinite()) << i;
    EXPECT_LT(result.energy.error, 0.005) << i;
    reassigned[i] = share;
  });
  // What changes of weights and contacts dissipate or add is a term of the balance and stays small.
  std::sort(reassigned.begin(), reassigned.end());
  EXPECT_GT(reassigned[kReleases / 20], -0.02);
  EXPECT_LT(reassigned[kReleases - kReleases / 20], 0.15);
}
INSTANTIATE_TEST_SUITE_P(Stiffness, Soak, testing::Values(false, true),
                         [](const auto& test) { return test.param ? "soft" : "auto"; });

}  // namespace
}  // namespace clast
