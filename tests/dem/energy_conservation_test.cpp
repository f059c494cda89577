// No law adds energy: blocks that bounce on ground that returns all or most of it.
#include <gtest/gtest.h>

#include <cmath>

#include "dem/contact/stiffness.hpp"
#include "tests/support/test_bodies.hpp"
#include "tests/support/test_rock.hpp"

namespace clast {
namespace {

constexpr double kGravity = 9.81;
/// The most that a run may gain, share of the energy that it began with.
constexpr double kMaxGained = 1e-3;
constexpr double kTime = 8.0;  // s, some ten impacts

struct Elastic {
  ContactLaw law;
  double energy_restitution;
  ContactWeighting weighting = ContactWeighting::kPatch;
};
void PrintTo(const Elastic& elastic, std::ostream* out) {
  *out << name_of(elastic.law) << ", e_n^2 " << elastic.energy_restitution << ", "
       << name_of(elastic.weighting);
}

/// Balls, boxes with sharp and rounded edges, slabs, rods and rocks.
RigidBody body_of_kind(int kind, std::uint64_t seed) {
  switch (kind) {
    case 0:
      return ball(100.0, 0.25);
    case 1:
      return box(500.0, {1.0, 0.8, 0.6});
    case 2:
      return box(500.0, {1.0, 1.0, 0.2}, 0.02, 2);
    case 3:
      return box(300.0, {1.5, 0.4, 0.3}, 0.02);
    default:
      return rock(3, {0.5, 0.4, 0.3}, 0.012, 2650.0, seed);
  }
}

struct Energies {
  double start = 0.0;    ///< kinetic, and potential above the lowest ground, J
  double most = -1e300;  ///< at the begin of any flight
  double last = 0.0;     ///< at the begin of the last flight
  bool bounced = false;
};

/// Kinetic and potential energy of a block that is thrown from so high, turned and spinning as the
/// seed says; every other one lands flat.
Energies bounce_of(const Elastic& elastic, int kind, std::uint64_t seed, double slope, int cells,
                   double height, double friction = 0.0) {
  Random random(seed);
  const RigidBody body = body_of_kind(kind, seed);
  const TerrainSurface terrain = ground(plane_mesh(200.0, cells, slope, seed));
  const std::vector<GroundParameters> zones{{elastic.energy_restitution, friction, 0.0}};
  RigidState start;
  start.position = {-100.0 * (slope > 0.0), 0.2, 100.0 * std::tan(slope) + height + 1.0};
  if (slope == 0.0) start.position.z() = height + 1.0;
  start.velocity = {1.0, 0.5, 0.0};
  if (seed % 2 == 0) {
    start.orientation = Quat(random.normal(), random.normal(), random.normal(), random.normal());
    start.orientation.normalize();
    start.angular_velocity = Vec3(random.normal(), random.normal(), random.normal());
  }
  ReleaseSettings settings;
  settings.law = elastic.law;
  settings.weighting = elastic.weighting;
  settings.max_time = kTime;
  StiffnessOptions options;
  options.law = elastic.law;
  const double fall = height + 1.0 + 400.0 * std::tan(slope);
  settings.stiffness = choose_stiffness(std::span(&body, 1), zones,
                                        std::sqrt(2.0 * kGravity * fall + 10.0), kGravity, options)
                           .stiffness;
  const auto energy = [&](const RigidState& state) {
    return translational_energy(body, state) + rotational_energy(body, state) +
           body.mass * kGravity * state.position.z();
  };
  Energies found;
  found.start = energy(start);
  simulate_release(terrain, zones, body, start, settings, [&](const MotionStep& step) {
    if (!step.flight) found.bounced = true;
    if (!step.correction_pending) found.most = std::max(found.most, energy(step.end));
    if (!step.flight || !found.bounced) return;
    found.last = energy(step.begin);
    found.most = std::max(found.most, found.last);
  });
  return found;
}

class EnergyConservation : public testing::TestWithParam<Elastic> {};

// Weights by overlap have no potential: without balance, a box gains or loses up to a third in an
// impact, whatever the time step.
TEST_P(EnergyConservation, NoBlockGainsEnergyOnFlatGround) {
  for (int kind = 0; kind < 5; ++kind) {
    for (const auto& [seed, cells, height] :
         {std::tuple(1, 1, 2.0), {2, 40, 2.0}, {3, 7, 0.3}, {4, 1, 10.0}}) {
      const Energies found = bounce_of(GetParam(), kind, seed, 0.0, cells, height);
      ASSERT_TRUE(found.bounced) << kind << " " << seed;
      EXPECT_LT(found.most, found.start * (1.0 + kMaxGained)) << kind << " " << seed;
      if (GetParam().energy_restitution == 1.0) {
        EXPECT_GT(found.last, 0.98 * found.start) << kind << " " << seed;
      }
    }
  }
}

TEST_P(EnergyConservation, NoBlockGainsEnergyOnASlope) {
  for (int kind = 0; kind < 5; ++kind) {
    for (const std::uint64_t seed : {1u, 2u}) {
      for (const double friction : {0.0, 0.4}) {
        const Energies found = bounce_of(GetParam(), kind, seed, 0.4, 20, 1.0, friction);
        EXPECT_LT(found.most, found.start * (1.0 + kMaxGained)) << kind << " " << seed;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    Laws, EnergyConservation,
    testing::Values(Elastic{EnergyRestitutionLaw(), 1.0}, Elastic{EnergyRestitutionLaw(), 0.99},
                    Elastic{EnergyRestitutionLaw(), 0.8}, Elastic{SpringDashpotLaw(), 1.0},
                    Elastic{SpringDashpotLaw(), 0.99}, Elastic{ElastoplasticLaw(), 1.0},
                    Elastic{ElastoplasticLaw(), 0.99},
                    Elastic{EnergyRestitutionLaw(), 1.0, ContactWeighting::kOverlap},
                    Elastic{EnergyRestitutionLaw(), 1.0, ContactWeighting::kNone},
                    // Not balanced: what is dissipated is more than is gained.
                    Elastic{EnergyRestitutionLaw(), 0.5}));

// A run that ends within an impact has what the impact will give back among what is stored.
TEST(ImpactEnergyCorrection, RunsThatEndWithinAnImpactKeepTheirEnergy) {
  const RigidBody body = box(500.0, {1.0, 0.8, 0.6});
  const TerrainSurface terrain = ground(plane_mesh(50.0, 2));
  const std::vector<GroundParameters> zones{{1.0, 0.0, 0.0}};
  ReleaseSettings settings = stiff_settings(body, 1e6);
  RigidState start;
  start.position = {0.2, 0.1, 1.5};
  start.orientation = Quat(0.9, 0.2, 0.3, 0.1).normalized();
  int within = 0;
  for (int i = 0; i < 200; ++i) {
    settings.max_time = 0.3 + 0.01 * i;
    const ReleaseResult run = simulate_release(terrain, zones, body, start, settings);
    within += run.settled_penetration > 0.0;
    EXPECT_NEAR(run.energy.final, run.energy.initial, 1e-3 * run.energy.initial) << i;
  }
  EXPECT_GT(within, 5);
}

// Of two zones only impacts on the elastic one are balanced.
TEST(ImpactEnergyCorrection, LeavesOtherGroundAsItIs) {
  const RigidBody body = box(500.0, {1.0, 0.8, 0.6}, 0.02);
  const auto last_state = [&](double elsewhere) {
    TriangleMesh mesh = plane_mesh(50.0, 2);
    std::vector<std::uint16_t> zone(mesh.triangles.size(), 0);
    // The block never comes to the far corner.
    zone.front() = 1;
    const TerrainSurface terrain(std::move(mesh), std::move(zone));
    const std::vector<GroundParameters> zones{{0.1, 0.3, 0.0}, {elsewhere, 0.3, 0.0}};
    RigidState start;
    start.position = {20.0, 20.0, 3.0};
    start.orientation = Quat(0.8, 0.3, -0.2, 0.4).normalized();
    ReleaseSettings settings = stiff_settings(body, 1e7);
    settings.max_time = 3.0;
    return simulate_release(terrain, zones, body, start, settings).final_state;
  };
  const RigidState with = last_state(1.0), without = last_state(0.1);
  EXPECT_EQ(with.position, without.position);
  EXPECT_EQ(with.orientation.coeffs(), without.orientation.coeffs());
}

}  // namespace
}  // namespace clast
