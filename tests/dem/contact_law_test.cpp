// The normal laws alone, along given paths of the overlap.
#include "dem/contact/contact_law.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/error.hpp"

namespace clast {
namespace {

constexpr double kLawStiffness = 1e6;

TEST(ContactLaw, NamesGoBothWaysAndOthersAreRefused) {
  for (const std::string& name : contact_law_names())
    EXPECT_EQ(name_of(parse_contact_law(name)), name);
  EXPECT_EQ(name_of(ContactLaw()), "energy-restitution");
  try {
    parse_contact_law("hertz");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(
        std::string(error.what()).find("energy-restitution or spring-dashpot or elastoplastic"),
        std::string::npos);
  }
}

/// A path h(t) = before + rate t + bend t^2.
OverlapPath path(double duration, double before, double rate, double quadratic_coefficient) {
  return {duration, before, before + rate * duration + quadratic_coefficient * duration * duration,
          rate};
}

/// Impulse, moment and work of a force over a path by many midpoints.
template <class Force>
NormalForceResponse summed(const OverlapPath& path, const Force& force) {
  NormalForceResponse sum;
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

void expect_corrects(const NormalForceResponse& response, const OverlapPath& path,
                     double first_force, const NormalForceResponse& exact, double last_force) {
  const double t = path.duration;
  const double scale =
      kLawStiffness * (std::abs(path.initial_overlap) + std::abs(path.initial_rate) * t);
  EXPECT_NEAR(response.force, last_force, 1e-9 * scale);
  EXPECT_NEAR(response.impulse + 0.5 * t * (first_force + response.force), exact.impulse,
              1e-5 * scale * t);
  EXPECT_NEAR(response.moment + 0.5 * t * t * first_force, exact.moment, 1e-5 * scale * t * t);
  EXPECT_NEAR(response.work, exact.work, 1e-5 * scale * std::abs(path.initial_rate) * t);
}

TEST(EnergyRestitution, ReversalInsideTheStepIsIntegratedExactly) {
  const EnergyRestitutionLaw law = EnergyRestitutionLaw::on_ground(kLawStiffness, {0.04, 0.0, 0.0});
  const OverlapPath turning = path(1e-3, 5e-3, 0.3, -500.0);  // deepest at 0.3 ms
  const double first = 4000.0;
  const NormalForceResponse exact = summed(turning, [&](double t) {
    return t < 3e-4 ? first + kLawStiffness * (turning.overlap_at(t) - 5e-3)
                    : 0.04 * kLawStiffness * turning.overlap_at(t);
  });
  expect_corrects(law.integrate(turning, {first}, 0.0), turning, first, exact,
                  0.04 * kLawStiffness * turning.final_overlap);
}

TEST(EnergyRestitution, StartAndEndInsideTheStepAreIntegratedExactly) {
  const EnergyRestitutionLaw law = EnergyRestitutionLaw::on_ground(kLawStiffness, {0.25, 0.0, 0.0});
  const OverlapPath starting = path(1e-3, -4e-4, 1.0, 50.0);
  expect_corrects(
      law.integrate(starting, {0.0}, 0.0), starting, 0.0,
      summed(starting,
             [&](double t) { return kLawStiffness * std::max(0.0, starting.overlap_at(t)); }),
      kLawStiffness * starting.final_overlap);
  const OverlapPath ending = path(1e-3, 4e-4, -1.0, -50.0);
  const double first = 0.25 * kLawStiffness * 4e-4;
  expect_corrects(
      law.integrate(ending, {first}, 0.0), ending, first,
      summed(ending,
             [&](double t) { return 0.25 * kLawStiffness * std::max(0.0, ending.overlap_at(t)); }),
      0.0);
}

TEST(EnergyRestitution, ReloadingInsideTheStepStartsFromTheUnloadingLine) {
  const EnergyRestitutionLaw law = EnergyRestitutionLaw::on_ground(kLawStiffness, {0.25, 0.0, 0.0});
  const OverlapPath turning = path(1e-3, 2e-3, -0.4, 500.0);  // shallowest at 0.4 ms
  const double shallowest = turning.overlap_at(4e-4);
  const auto force = [&](double t) {
    return t < 4e-4 ? 0.25 * kLawStiffness * turning.overlap_at(t)
                    : 0.25 * kLawStiffness * shallowest +
                          kLawStiffness * (turning.overlap_at(t) - shallowest);
  };
  const double first = 0.25 * kLawStiffness * 2e-3;
  expect_corrects(law.integrate(turning, {first}, 0.0), turning, first, summed(turning, force),
                  force(1e-3));
}

TEST(EnergyRestitution, SmoothStepsAreLeftToTheScheme) {
  const EnergyRestitutionLaw law = EnergyRestitutionLaw::on_ground(kLawStiffness, {0.25, 0.0, 0.0});
  const NormalForceResponse loading = law.integrate(path(1e-3, 2e-3, 0.4, 10.0), {1500.0}, 0.0);
  EXPECT_EQ(loading.impulse, 0.0);
  EXPECT_EQ(loading.moment, 0.0);
  EXPECT_NEAR(loading.force, 1500.0 + kLawStiffness * 4.1e-4, 1e-6);
}

TEST(SpringDashpot, EndOfThePushInsideTheStepIsIntegratedExactly) {
  const SpringDashpotLaw law = SpringDashpotLaw::on_ground(kLawStiffness, {0.25, 0.0, 0.0});
  const double c = law.damping_coefficient(2.0);
  const OverlapPath ending = path(1e-3, 8e-4, -0.2, -600.0);
  const auto force = [&](double t) {
    return std::max(0.0, kLawStiffness * ending.overlap_at(t) + c * ending.rate_at(t));
  };
  ASSERT_GT(force(0.0), 0.0);
  ASSERT_EQ(force(1e-3), 0.0);
  expect_corrects(law.integrate(ending, {force(0.0)}, 2.0), ending, force(0.0),
                  summed(ending, force), 0.0);
}

class DashpotRestitution : public testing::TestWithParam<double> {};

// The oscillator m h'' + c h' + k h = 0 from h = 0, h' = 1, by Runge-Kutta, until m h'' = 0.
TEST_P(DashpotRestitution, IsThatOfTheOscillatorThatNeverPulls) {
  const double ratio = damping_ratio_for_restitution(GetParam());
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

constexpr double kE = 0.25;                                   ///< e_n^2 of what yields
constexpr double kUnloading = kLawStiffness / kE;             ///< k_2
constexpr double kReloadingRatio = 2.0 * kLawStiffness / kE;  ///< k_3
ElastoplasticLaw yielding() { return ElastoplasticLaw::on_ground(kLawStiffness, {kE, 0.0, 0.0}); }

TEST(Elastoplastic, FirstLoadingThatTurnsInsideTheStepIsIntegratedExactly) {
  const OverlapPath turning = path(1e-3, 5e-3, 0.3, -500.0);  // deepest at 0.3 ms
  const double deepest = turning.overlap_at(3e-4), residual_indentation = deepest * (1.0 - kE);
  const double first = kLawStiffness * 5e-3;
  const auto force = [&](double t) {
    return t < 3e-4 ? kLawStiffness * turning.overlap_at(t)
                    : kUnloading * (turning.overlap_at(t) - residual_indentation);
  };
  const NormalForceResponse response =
      yielding().integrate(turning, {first, 5e-3 * (1.0 - kE)}, 0.0);
  expect_corrects(response, turning, first, summed(turning, force), force(1e-3));
  EXPECT_NEAR(response.residual_indentation, residual_indentation, 1e-12);
}

TEST(Elastoplastic, LetsGoAtTheDentAndIsLooseAboveIt) {
  const double residual_indentation = 3e-3;
  const OverlapPath rising = path(1e-3, 3.2e-3, -0.5, -10.0);
  const double first = kUnloading * 0.2e-3;
  const NormalForceResponse response =
      yielding().integrate(rising, {first, residual_indentation}, 0.0);
  expect_corrects(response, rising, first,
                  summed(rising,
                         [&](double t) {
                           return std::max(
                               0.0, kUnloading * (rising.overlap_at(t) - residual_indentation));
                         }),
                  0.0);
  EXPECT_EQ(response.residual_indentation, residual_indentation);
  const NormalForceResponse loose =
      yielding().integrate(path(1e-3, 1e-3, 0.5, 10.0), {0.0, residual_indentation}, 0.0);
  EXPECT_EQ(loose.force, 0.0);
  EXPECT_EQ(loose.work, 0.0);
  EXPECT_EQ(loose.impulse, 0.0);
}

TEST(Elastoplastic, LoadsAgainFromTheDentUpToTheLineOfFirstLoading) {
  const double residual_indentation = 3e-3;  // and so the deepest was at 4 mm
  const OverlapPath falling = path(1e-3, 2.8e-3, 2.0, -50.0);
  const double meet = kReloadingRatio * residual_indentation / (kReloadingRatio - kLawStiffness);
  ASSERT_LT(meet, falling.final_overlap);
  const auto force = [&](double t) {
    const double h = falling.overlap_at(t);
    return h > meet ? kLawStiffness * h : kReloadingRatio * std::max(0.0, h - residual_indentation);
  };
  const NormalForceResponse response =
      yielding().integrate(falling, {0.0, residual_indentation}, 0.0);
  expect_corrects(response, falling, 0.0, summed(falling, force), force(1e-3));
  EXPECT_NEAR(response.residual_indentation, falling.final_overlap * (1.0 - kE), 1e-12);
}

/// Slowly up and down, without events: to 4 mm, back to 3.5, again to 5, and out. Unloading and
/// what it stores end where a straight line from (h, k_1 h) of slope k_2 does, and all that is not
/// given back is lost.
TEST(Elastoplastic, LosesTheAreaBetweenItsLines) {
  const ElastoplasticLaw law = yielding();
  NormalForceState state;
  double overlap = 0.0, work = 0.0;
  const auto go = [&](double to) {
    constexpr int kSteps = 1000;
    const double from = overlap;
    for (int i = 1; i <= kSteps; ++i) {
      const double next = from + (to - from) * i / kSteps;
      const NormalForceResponse response =
          law.integrate({1.0, overlap, next, next - overlap}, state, 0.0);
      work += response.work;
      state = {response.force, response.residual_indentation};
      overlap = next;
    }
  };
  go(4e-3);
  EXPECT_NEAR(state.force, 4e3, 1e-6);
  EXPECT_NEAR(state.residual_indentation, 3e-3, 1e-9);
  EXPECT_NEAR(work, 8.0, 1e-6);  // k_1 h^2/2
  go(3.5e-3);
  EXPECT_NEAR(state.force, 2e3, 1e-6);
  EXPECT_NEAR(law.stored_energy(overlap, state.residual_indentation),
              2e3 * 2e3 / (2.0 * kUnloading), 1e-9);
  // From (3.5 mm, 2 kN) by k_3 = 8 kN/mm to k_1 h at 26/7 mm, and on along that.
  go(5e-3);
  EXPECT_NEAR(state.force, 5e3, 1e-6);
  EXPECT_NEAR(state.residual_indentation, 3.75e-3, 1e-9);
  go(0.0);
  EXPECT_EQ(state.force, 0.0);
  const double meet = 26.0 / 7.0;  // mm; forces in kN, so work in J
  const double unloaded = 0.5 * (4.0 + 2.0) * 0.5, reloaded = 0.5 * (2.0 + meet) * (meet - 3.5);
  const double deeper = 0.5 * (meet + 5.0) * (5.0 - meet), returned = 0.5 * 5.0 * 1.25;
  EXPECT_NEAR(work, 8.0 - unloaded + reloaded + deeper - returned, 1e-5);
}

TEST(Elastoplastic, WithoutLossIsALinearSpring) {
  const ElastoplasticLaw law = ElastoplasticLaw::on_ground(kLawStiffness, {1.0, 0.0, 0.0});
  for (const double rate : {-2.0, 2.0}) {
    const NormalForceResponse response =
        law.integrate(path(1e-3, 3e-3, rate, 10.0), {kLawStiffness * 3e-3}, 0.0);
    EXPECT_NEAR(response.force, kLawStiffness * (3e-3 + 1e-3 * rate + 1e-5), 1e-6);
    EXPECT_NEAR(response.impulse, 0.0, 1e-9);
  }
  EXPECT_EQ(law.highest_frequency(1.0), 1.0);
}

TEST(SpringDashpot, NoDampingKeepsAllEnergy) { EXPECT_EQ(damping_ratio_for_restitution(1.0), 0.0); }

}  // namespace
}  // namespace clast
