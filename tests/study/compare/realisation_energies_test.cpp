// Where the energy of blocks that stay goes, against samples written by hand.
#include "study/compare/realisation_energies.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "study/compare/deposit_quantities.hpp"
#include "study/compare/realisation_deposits.hpp"
#include "tests/study/energies_that_are_lost.hpp"

namespace clast {
namespace {

double kinetic(const EnergySample& sample) { return sample.translational + sample.rotational; }

TEST(RealisationEnergies, GoByFileAndRealisation) {
  const Comparison comparison = compared(energies_that_are_lost());
  const std::vector<RealisationEnergies> all = collect_realisation_energies(comparison);
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(all[1].file, 0u);
  EXPECT_EQ(all[1].realisation, 1u);
  ASSERT_EQ(all[0].samples.size(), 3u);
  EXPECT_EQ(all[0].samples[1].time, 2.0);
}

TEST(RealisationEnergies, SharesAreOfWhatContactsDissipated) {
  const Comparison comparison = compared(energies_that_are_lost());
  const EnergyFractions shares =
      compute_energy_fractions(collect_realisation_energies(comparison)[0].samples);
  EXPECT_DOUBLE_EQ(shares.on_ground.friction, 0.4);
  EXPECT_DOUBLE_EQ(shares.on_ground.normal, 0.2);
  EXPECT_DOUBLE_EQ(shares.between_blocks.friction, 0.3);
  EXPECT_DOUBLE_EQ(shares.between_blocks.rolling, 0.1);
  EXPECT_DOUBLE_EQ(shares.on_ground.sum() + shares.between_blocks.sum(), 1.0);
  EXPECT_DOUBLE_EQ(shares.largest_kinetic, 500.0);
  const EnergyFractions none = compute_energy_fractions({EnergySample{}});
  EXPECT_TRUE(std::isnan(none.on_ground.friction));
  EXPECT_EQ(none.largest_kinetic, 0.0);
}

TEST(RealisationEnergies, CurvesAreLinearBetweenSamplesAndLast) {
  const Comparison comparison = compared(energies_that_are_lost());
  const std::vector<RealisationEnergies> all = collect_realisation_energies(comparison);
  const RealisationCurve curve = compute_energy_curve({&all[0], &all[1]}, kinetic);
  ASSERT_GT(curve.time.size(), 2u);
  EXPECT_EQ(curve.time.front(), 0.0);
  EXPECT_DOUBLE_EQ(curve.time.back(), 8.0);  // the second takes twice as long
  EXPECT_EQ(curve.mean.front(), 0.0);
  for (std::size_t i = 0; i < curve.time.size(); ++i) {
    const double t = curve.time[i];
    const double first = t < 2.0 ? 250.0 * t : t < 4.0 ? 250.0 * (4.0 - t) : 0.0;
    const double second = t < 4.0 ? 125.0 * t : 125.0 * (8.0 - t);
    EXPECT_NEAR(curve.mean[i], 0.5 * (first + second), 1e-9) << t;
    EXPECT_NEAR(curve.minimum[i], std::min(first, second), 1e-9) << t;
    EXPECT_NEAR(curve.maximum[i], std::max(first, second), 1e-9) << t;
  }
  EXPECT_TRUE(compute_energy_curve({}, kinetic).time.empty());
}

TEST(RealisationEnergies, AreFiguresOfTheDeposit) {
  CampaignResults results = energies_that_are_lost();
  const auto mean_of = [](const CampaignResults& of, const std::string& name) -> double {
    const DepositQuantityComparison figures =
        compare_deposit_quantities(measure_deposits(compared(of)).realisations);
    for (const DepositQuantitySummary& one : figures.files) {
      if (deposit_quantities()[one.quantity].name == name) return one.summary.mean;
    }
    return NAN;
  };
  EXPECT_DOUBLE_EQ(mean_of(results, "dissipated_by_friction"), 0.7);
  EXPECT_DOUBLE_EQ(mean_of(results, "dissipated_by_rolling"), 0.1);
  EXPECT_DOUBLE_EQ(mean_of(results, "dissipated_between_blocks"), 0.4);
  EXPECT_DOUBLE_EQ(mean_of(results, "largest_kinetic_j"), 500.0);
  results.energies.clear();  // of an older program
  EXPECT_TRUE(std::isnan(mean_of(results, "dissipated_by_friction")));
  EXPECT_TRUE(collect_realisation_energies(compared(results)).empty());
}

}  // namespace
}  // namespace clast
