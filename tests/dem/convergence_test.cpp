// Order of the time integration for one frictionless contact, against the closed forms.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/support/test_bodies.hpp"

namespace clast {
namespace {

constexpr double kFrequency = 1e3;  ///< sqrt(k_n/m), rad/s

struct Case {
  const char* name;
  ContactLaw law;
  double energy_restitution;
};
void PrintTo(const Case& which, std::ostream* out) { *out << which.name; }

/// How long the contact lasts, and how deep it ends.
std::pair<double, double> contact_end(const Case& which) {
  const double restitution = std::sqrt(which.energy_restitution);
  if (std::holds_alternative<EnergyRestitutionLaw>(which.law)) {
    return {0.5 * kPi / kFrequency * (1.0 + 1.0 / restitution), 0.0};
  }
  if (std::holds_alternative<ElastoplasticLaw>(which.law)) {
    return {0.5 * kPi / kFrequency * (1.0 + restitution),
            (1.0 - which.energy_restitution) / kFrequency};
  }
  const double ratio = damping_ratio_for_restitution(which.energy_restitution);
  const double depth = 2.0 * ratio * restitution / kFrequency;
  if (ratio < 1.0) {
    return {2.0 * std::acos(ratio) / (kFrequency * std::sqrt(1.0 - ratio * ratio)), depth};
  }
  return {2.0 * std::acosh(ratio) / (kFrequency * std::sqrt(ratio * ratio - 1.0)), depth};
}

/// Error of the centre 5 ms after a unit mass at 1 m/s has left again, root mean square over steps
/// that reach the reversal at different places, and the largest error of the energy balance.
struct Error {
  double position = 0.0;
  double energy_balance = 0.0;
  double reassigned = 0.0;
};
Error error_at(const Case& which, double halvings) {
  static const TerrainSurface terrain = ground(plane_mesh(2.0, 3));
  const RigidBody body = ball(1.0, 0.1);
  const auto [duration, depth] = contact_end(which);
  const double gap = 0.0123, after = 0.005;
  double squares = 0.0;
  Error error;
  const std::vector<double> factors = {0.1, 0.0935, 0.0855, 0.0815, 0.0755, 0.0715, 0.0665, 0.0645};
  for (const double factor : factors) {
    ReleaseSettings settings;
    const double stiffness = kFrequency * kFrequency;
    const bool yields = std::holds_alternative<ElastoplasticLaw>(which.law);
    const double rate = yields ? kFrequency / std::sqrt(which.energy_restitution) : kFrequency;
    settings.stiffness = {stiffness, stiffness, stiffness, factor / rate * halvings};
    settings.law = which.law;
    settings.gravity = 0.0;
    settings.max_time = gap + duration + after;
    RigidState start;
    start.position = {0.1, 0.2, 0.1 + gap};
    start.velocity = {0.0, 0.0, -1.0};
    const ReleaseResult result = simulate_release(
        terrain, std::vector<GroundParameters>{{which.energy_restitution, 0.0, 0.0}}, body, start,
        settings);
    const double exact = 0.1 - depth + std::sqrt(which.energy_restitution) * after;
    squares += std::pow(result.final_state.position.z() - exact, 2.0);
    error.energy_balance = std::max(error.energy_balance, result.energy.error);
    error.reassigned = std::max(error.reassigned, std::abs(result.energy.reassigned));
  }
  error.position = std::sqrt(squares / static_cast<double>(factors.size()));
  return error;
}

class Convergence : public testing::TestWithParam<Case> {};

TEST_P(Convergence, IsOfSecondOrderOverFourHalvings) {
  double coarser = error_at(GetParam(), 1.0).position;
  const double first = coarser;
  for (const double halvings : {0.5, 0.25, 0.125, 0.0625}) {
    const Error error = error_at(GetParam(), halvings);
    EXPECT_GT(std::log2(coarser / error.position), 1.9) << "step times " << halvings;
    EXPECT_LT(error.energy_balance, 1e-10);
    coarser = error.position;
  }
  EXPECT_LT(first, 1e-5);
}

// A single clean contact loses nothing to events: what is booked there is an error of the step.
TEST_P(Convergence, NothingIsReassignedInTheLimit) {
  const double coarse = error_at(GetParam(), 0.5).reassigned;
  if (GetParam().energy_restitution == 1.0) {  // such impacts are balanced
    EXPECT_LT(coarse, 1e-12);
    return;
  }
  EXPECT_LT(coarse, 0.002 * 0.5);
  EXPECT_GT(std::log2(coarse / error_at(GetParam(), 0.125).reassigned), 2.0 * 1.7);
}

INSTANTIATE_TEST_SUITE_P(Laws, Convergence,
                         testing::Values(Case{"elastic", EnergyRestitutionLaw(), 1.0},
                                         Case{"quarter", EnergyRestitutionLaw(), 0.25},
                                         Case{"hundredth", EnergyRestitutionLaw(), 0.01},
                                         Case{"dashpot_quarter", SpringDashpotLaw(), 0.25},
                                         Case{"dashpot_hundredth", SpringDashpotLaw(), 0.01},
                                         Case{"yielding_quarter", ElastoplasticLaw(), 0.25},
                                         Case{"yielding_hundredth", ElastoplasticLaw(), 0.01}),
                         [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace clast
