// Soil that remembers dents, against closed forms.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "core/error.hpp"
#include "dem/contact/elastoplastic_law.hpp"
#include "dem/contact/soil_memory.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/test_worlds.hpp"

namespace clast {
namespace {

constexpr double kRestitution = 0.25, kSoilMass = 1000.0, kSoilRadius = 0.5, kSoilStiffness = 4e7;

GroundParameters remembering(double width) {
  GroundParameters ground{kRestitution, 0.0, 0.0};
  ground.soil_memory = width;
  return ground;
}

/// Balls that come down on flat ground one after the other, without gravity.
class Range {
 public:
  explicit Range(double width, unsigned threads = 1)
      : world_({body_}, settings(body_, threads), terrain_, {remembering(width)}) {}

  /// @return the share of its energy that the ball leaves with; then it is taken away
  double drop(double x, double speed) {
    const std::size_t number =
        world_.add_body(0, at({x, 0.01, kSoilRadius + 1e-4}, {0, 0, -speed}));
    while (world_.state(number).velocity.z() <= 0.0 ||
           world_.contact_summary(number).contact_count > 0) {
      world_.step();
    }
    const double kept = world_.state(number).velocity.z() / speed;
    world_.remove_body(number);
    return kept * kept;
  }

  static WorldSettings settings(const RigidBody& body, unsigned threads) {
    WorldSettings settings = stiff_world(body, kSoilStiffness, 100.0);
    settings.law = ElastoplasticLaw();
    settings.threads = threads;
    return settings;
  }

 private:
  TerrainSurface terrain_ = ground(plane_mesh(5.0, 6));
  RigidBody body_ = ball(kSoilMass, kSoilRadius);
  World world_;
};

/// What an impact of energy k_1/2 on soil with this dent keeps, and the dent that it leaves, for
/// k_1 = 1, k_2 = 1/e and k_3 = 2 k_2.
double kept_of(double& residual_indentation) {
  const double k2 = 1.0 / kRestitution, k3 = ElastoplasticLaw::kReloadingRatio * k2;
  const double meet = k3 * residual_indentation / (k3 - 1.0);  // with the line of first loading
  const double until_there =
      0.5 * k3 * (meet - residual_indentation) * (meet - residual_indentation);
  const double deepest = std::sqrt(meet * meet + 2.0 * (0.5 - until_there));
  residual_indentation = (1.0 - kRestitution) * deepest;
  return kRestitution * deepest * deepest;
}

// Each impact at the same place goes deeper than the one before, and returns more.
TEST(SoilMemory, HardensFromImpactToImpact) {
  Range range(0.2);
  double residual_indentation = 0.0;
  for (int i = 0; i < 4; ++i) {
    const double kept = kept_of(residual_indentation);
    EXPECT_NEAR(range.drop(0.05, 2.0), kept, 0.002) << "impact " << i + 1;
  }
}

TEST(SoilMemory, ASlowImpactInsideADentReturnsTheShareOfReloading) {
  Range range(0.2);
  range.drop(0.05, 2.0);
  // The first went to 1, its dent is 0.75: up to an energy of 0.046 of it nothing yields.
  EXPECT_NEAR(range.drop(0.05, 0.4), 1.0 / ElastoplasticLaw::kReloadingRatio, 0.005);
}

TEST(SoilMemory, OtherCellsAndGroundWithoutMemoryKnowNothing) {
  Range range(0.2), without(0.0);
  for (Range* one : {&range, &without}) one->drop(0.05, 2.0);
  EXPECT_NEAR(range.drop(0.25, 2.0), kRestitution, 0.002);
  EXPECT_NEAR(without.drop(0.05, 2.0), kRestitution, 0.002);
}

// A block finds no dent that it is just making: alone it moves as on ground without memory, to the
// bit, until it comes back to where it was.
TEST(SoilMemory, ABlockDoesNotFindTheDentsOfItsOwnTouch) {
  const TerrainSurface terrain = ground(plane_mesh(20.0, 10));
  const RigidBody body = rock(4, {0.5, 0.4, 0.3}, 0.01, 2650.0, 3);
  std::vector<RigidState> ends;
  for (const double width : {0.0, 5.0}) {
    GroundParameters soil{0.1, 0.6, 0.1};
    soil.soil_memory = width;
    WorldSettings settings = Range::settings(body, 1);
    StiffnessOptions yielding;
    yielding.law = ElastoplasticLaw();
    settings.stiffness = choose_stiffness(std::span(&body, 1), std::vector<GroundParameters>{soil},
                                          5.0, 9.81, yielding)
                             .stiffness;
    settings.gravity = 9.81;
    World world({body}, settings, terrain, {soil});
    world.add_body(0, at({-10.0, 0.0, 0.505}, {2.0, 0.0, -1.0}));
    while (world.contact_summary(0).contact_count == 0) world.step();
    while (world.contact_summary(0).contact_count > 0 && world.time() < 0.5) world.step();
    ends.push_back(world.state(0));
  }
  EXPECT_EQ(ends[0].position, ends[1].position);
  EXPECT_EQ(ends[0].angular_velocity, ends[1].angular_velocity);
}

TEST(SoilMemory, IsTheSameOnAnyNumberOfThreads) {
  const TerrainSurface terrain = ground(bowl());
  std::vector<std::vector<Vec3>> ends;
  for (const unsigned threads : {1u, 3u}) {
    const RigidBody body = rock(2, {0.3, 0.25, 0.2}, 0.01, 2650.0, 3);
    GroundParameters soil{0.05, 0.6, 0.1};
    soil.soil_memory = 0.2;
    WorldSettings settings = Range::settings(body, threads);
    settings.stiffness = stiff_settings(body, 1e7, 60.0).stiffness;
    settings.gravity = 9.81;
    settings.between_bodies = {0.05, 0.6, 0.1};
    World world({body}, settings, terrain, {soil});
    for (int i = 0; i < 24; ++i) {
      world.add_body(0, at({0.9 * (i % 6) - 2.2, 0.9 * (i / 6) - 1.3, 2.5}, {0.5, 0.0, -4.0}));
    }
    world.run_until_rest(1.0);
    ends.emplace_back();
    for (std::size_t i = 0; i < world.body_count(); ++i) {
      ends.back().push_back(world.state(i).position);
    }
  }
  EXPECT_EQ(ends[0], ends[1]);
}

TEST(SoilMemory, LawsWithoutDentsAndSingleReleasesAreRefused) {
  const TerrainSurface terrain = ground(plane_mesh(5.0, 6));
  const RigidBody body = ball(kSoilMass, kSoilRadius);
  WorldSettings settings = Range::settings(body, 1);
  settings.law = {};
  EXPECT_EQ(refusal<InputError>([&] { World({body}, settings, terrain, {remembering(0.2)}); }),
            "soil_memory of a ground zone needs the law elastoplastic, which leaves residual "
            "indentations");
  ReleaseSettings release = stiff_settings(body, kSoilStiffness);
  release.law = ElastoplasticLaw();
  EXPECT_EQ(
      refusal<InputError>([&] {
        simulate_release(terrain, std::vector{remembering(0.2)}, body, at({0, 0, 1}), release);
      }),
      "soil_memory = 0.2: residual indentations of a single release meet no later blocks; give 0");
}

TEST(SoilMemory, KeepsTheDeepestOfEachCell) {
  const std::vector<GroundParameters> zones = {remembering(0.5), remembering(0.0)};
  dem_detail::SoilMemory soil(zones), other(zones);
  EXPECT_TRUE(soil.is_enabled());
  soil.add_indentation({0.1, -0.1, 7.0}, 0, 0.03);
  soil.add_indentation({0.4, -0.4, -3.0}, 0, 0.01);
  soil.add_indentation({0.1, -0.1, 7.0}, 1, 0.5);
  other.add_indentation({0.2, -0.2, 0.0}, 0, 0.04);
  other.add_indentation({-0.2, -0.2, 0.0}, 0, 0.02);
  EXPECT_EQ(soil.residual_indentation({0.49, -0.01, 0.0}, 0), 0.03);
  EXPECT_EQ(soil.residual_indentation({0.1, -0.1, 7.0}, 1), 0.0);
  soil.merge(other);
  EXPECT_TRUE(other.empty());
  EXPECT_EQ(soil.residual_indentation({0.49, -0.01, 0.0}, 0), 0.04);
  EXPECT_EQ(soil.residual_indentation({-0.01, -0.01, 0.0}, 0), 0.02);
  EXPECT_EQ(soil.residual_indentation({0.49, 0.01, 0.0}, 0), 0.0);
}

}  // namespace
}  // namespace clast
