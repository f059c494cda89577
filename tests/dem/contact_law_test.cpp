// The normal laws alone, along given paths of the overlap.
#include "dem/contact_law.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/error.hpp"

namespace clast {
namespace {

constexpr double kStiffness = 1e6;

TEST(ContactLaw, NamesGoBothWaysAndOthersAreRefused) {
  for (const std::string& name : contact_law_names()) EXPECT_EQ(name_of(contact_law(name)), name);
  EXPECT_EQ(name_of(ContactLaw()), "energy-restitution");
  try {
    contact_law("hertz");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("energy-restitution or spring-dashpot"),
              std::string::npos);
  }
}

/// A path h(t) = before + rate t + bend t^2.
OverlapPath path(double duration, double before, double rate, double bend) {
  return {duration, before, before + rate * duration + bend * duration * duration, rate};
}

/// Impulse, moment and work of a force over a path by many midpoints.
template <class Force>
NormalResponse summed(const OverlapPath& path, const Force& force) {
  NormalResponse sum;
  constexpr int kPieces = 200000;
  const double dt = path.duration / kPieces;
  for (int i = 0; i < kPieces; ++i) {
    const double t = (i + 0.5) * dt, f = force(t);
    sum.impulse += f * dt;
    sum.moment += f * (path.duration - t) * dt;
    sum.work += f * path.rate_at(t) * dt;
  }
  return sum;
}

void expect_corrects(const NormalResponse& response, const OverlapPath& path, double first_force,
                     const NormalResponse& exact, double last_force) {
  const double t = path.duration;
  const double scale = kStiffness * (std::abs(path.before) + std::abs(path.rate) * t);
  EXPECT_NEAR(response.force, last_force, 1e-9 * scale);
  EXPECT_NEAR(response.impulse + 0.5 * t * (first_force + response.force), exact.impulse,
              1e-5 * scale * t);
  EXPECT_NEAR(response.moment + 0.5 * t * t * first_force, exact.moment, 1e-5 * scale * t * t);
  EXPECT_NEAR(response.work, exact.work, 1e-5 * scale * std::abs(path.rate) * t);
}

TEST(EnergyRestitution, ReversalInsideTheStepIsIntegratedExactly) {
  const EnergyRestitutionLaw law = EnergyRestitutionLaw::of(kStiffness, {0.04, 0.0, 0.0});
  const OverlapPath turning = path(1e-3, 5e-3, 0.3, -500.0);  // deepest at 0.3 ms
  const double first = 4000.0;
  const NormalResponse exact = summed(turning, [&](double t) {
    return t < 3e-4 ? first + kStiffness * (turning.at(t) - 5e-3)
                    : 0.04 * kStiffness * turning.at(t);
  });
  expect_corrects(law.along(turning, first, 0.0), turning, first, exact,
                  0.04 * kStiffness * turning.after);
}

TEST(EnergyRestitution, StartAndEndInsideTheStepAreIntegratedExactly) {
  const EnergyRestitutionLaw law = EnergyRestitutionLaw::of(kStiffness, {0.25, 0.0, 0.0});
  const OverlapPath starting = path(1e-3, -4e-4, 1.0, 50.0);
  expect_corrects(
      law.along(starting, 0.0, 0.0), starting, 0.0,
      summed(starting, [&](double t) { return kStiffness * std::max(0.0, starting.at(t)); }),
      kStiffness * starting.after);
  const OverlapPath ending = path(1e-3, 4e-4, -1.0, -50.0);
  const double first = 0.25 * kStiffness * 4e-4;
  expect_corrects(
      law.along(ending, first, 0.0), ending, first,
      summed(ending, [&](double t) { return 0.25 * kStiffness * std::max(0.0, ending.at(t)); }),
      0.0);
}

TEST(EnergyRestitution, ReloadingInsideTheStepStartsFromTheUnloadingLine) {
  const EnergyRestitutionLaw law = EnergyRestitutionLaw::of(kStiffness, {0.25, 0.0, 0.0});
  const OverlapPath turning = path(1e-3, 2e-3, -0.4, 500.0);  // shallowest at 0.4 ms
  const double shallowest = turning.at(4e-4);
  const auto force = [&](double t) {
    return t < 4e-4 ? 0.25 * kStiffness * turning.at(t)
                    : 0.25 * kStiffness * shallowest + kStiffness * (turning.at(t) - shallowest);
  };
  const double first = 0.25 * kStiffness * 2e-3;
  expect_corrects(law.along(turning, first, 0.0), turning, first, summed(turning, force),
                  force(1e-3));
}

TEST(EnergyRestitution, SmoothStepsAreLeftToTheScheme) {
  const EnergyRestitutionLaw law = EnergyRestitutionLaw::of(kStiffness, {0.25, 0.0, 0.0});
  const NormalResponse loading = law.along(path(1e-3, 2e-3, 0.4, 10.0), 1500.0, 0.0);
  EXPECT_EQ(loading.impulse, 0.0);
  EXPECT_EQ(loading.moment, 0.0);
  EXPECT_NEAR(loading.force, 1500.0 + kStiffness * 4.1e-4, 1e-6);
}

TEST(SpringDashpot, EndOfThePushInsideTheStepIsIntegratedExactly) {
  const SpringDashpotLaw law = SpringDashpotLaw::of(kStiffness, {0.25, 0.0, 0.0});
  const double c = law.damping(2.0);
  const OverlapPath ending = path(1e-3, 8e-4, -0.2, -600.0);
  const auto force = [&](double t) {
    return std::max(0.0, kStiffness * ending.at(t) + c * ending.rate_at(t));
  };
  ASSERT_GT(force(0.0), 0.0);
  ASSERT_EQ(force(1e-3), 0.0);
  expect_corrects(law.along(ending, force(0.0), 2.0), ending, force(0.0), summed(ending, force),
                  0.0);
}

class DashpotRestitution : public testing::TestWithParam<double> {};

// The oscillator m h'' + c h' + k h = 0 from h = 0, h' = 1, by Runge-Kutta, until m h'' = 0.
TEST_P(DashpotRestitution, IsThatOfTheOscillatorThatNeverPulls) {
  const double ratio = damping_ratio(GetParam());
  const double dt = 1e-5;
  double h = 0.0, v = 1.0;
  const auto acceleration = [&](double at, double rate) { return -at - 2.0 * ratio * rate; };
  while (acceleration(h, v) < 0.0) {
    const double k1 = v, l1 = acceleration(h, v);
    const double k2 = v + 0.5 * dt * l1, l2 = acceleration(h + 0.5 * dt * k1, k2);
    const double k3 = v + 0.5 * dt * l2, l3 = acceleration(h + 0.5 * dt * k2, k3);
    const double k4 = v + dt * l3, l4 = acceleration(h + dt * k3, k4);
    h += dt / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
    v += dt / 6.0 * (l1 + 2.0 * l2 + 2.0 * l3 + l4);
  }
  EXPECT_NEAR(-v, std::sqrt(GetParam()), 1e-6);
}
INSTANTIATE_TEST_SUITE_P(Restitutions, DashpotRestitution,
                         testing::Values(0.81, 0.25, 0.0183156388887, 0.01, 1e-4));

TEST(SpringDashpot, NoDampingKeepsAllEnergy) { EXPECT_EQ(damping_ratio(1.0), 0.0); }

}  // namespace
}  // namespace clast
