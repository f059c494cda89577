#include "classify/scanned_deposit.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "tests/classify/deposit_samples.hpp"

namespace clast {
namespace {

constexpr std::size_t kI = 1, kD50 = 1;

const WeightedSizes& sizes_by(const ScannedDepositSummary& summary, SizeWeighting weighting) {
  return summary.sizes[static_cast<std::size_t>(weighting)];
}

ScannedDepositSummary summary_of(const Population& population, unsigned threads = 0) {
  return summarise_scanned_deposit(population, {.schemes = {"sneed-folk", "garcia"}}, threads)
      .value();
}

TEST(ScannedDeposit, NeedsThreeBlocksOfADeposit) {
  SampledDeposit deposit = sample_deposit(50, 1);
  deposit.found.blocks.resize(2);
  EXPECT_FALSE(summarise_scanned_deposit(deposit.found, {}));
  Population taped{"taped", {}};
  for (int k = 0; k < 20; ++k) taped.blocks.push_back(make_measured_block("T", {3.0, 2.0, 1.0}));
  EXPECT_FALSE(summarise_scanned_deposit(taped, {}));
}

TEST(ScannedDeposit, GridCountsAreCoarserThanNumbersAndCorrectedOnesFiner) {
  const ScannedDepositSummary summary = summary_of(sample_deposit(300, 2).found);
  const auto d50 = [&](SizeWeighting weighting) {
    return sizes_by(summary, weighting).percentiles[kI][kD50].value;
  };
  EXPECT_GT(d50(SizeWeighting::kGrid), 1.2 * d50(SizeWeighting::kNumber));
  EXPECT_GT(d50(SizeWeighting::kArea), 1.2 * d50(SizeWeighting::kNumber));
  EXPECT_LT(d50(SizeWeighting::kCorrected), d50(SizeWeighting::kNumber));
  EXPECT_GT(summary.corrected_blocks.value, static_cast<double>(summary.blocks));
}

TEST(ScannedDeposit, PercentilesAscendInsideTheirIntervals) {
  const ScannedDepositSummary summary = summary_of(sample_deposit(200, 3).found);
  for (const WeightedSizes& sizes : summary.sizes) {
    for (const auto& percentiles : sizes.percentiles) {
      double last = 0.0;
      for (const EstimatedValue& estimate : percentiles) {
        EXPECT_GE(estimate.value, last);
        EXPECT_LE(estimate.interval.low, estimate.value);
        EXPECT_GE(estimate.interval.high, estimate.value);
        last = estimate.value;
      }
    }
  }
}

/// Twenty deposits, whose true numbers are known.
TEST(ScannedDeposit, IntervalsHoldTheTruthOfTheWholeDeposit) {
  int inside = 0, all = 0, medians = 0;
  constexpr int kDeposits = 20;
  for (int seed = 101; seed < 101 + kDeposits; ++seed) {
    const SampledDeposit deposit = sample_deposit(200, static_cast<std::uint64_t>(seed));
    const ScannedDepositSummary summary = summary_of(deposit.found);
    std::map<std::string, double> truth;
    std::vector<double> sizes;
    for (const Axes& axes : deposit.truth) {
      truth[sneed_folk_class(axes)] += 1.0 / static_cast<double>(deposit.truth.size());
      sizes.push_back(axes.I);
    }
    for (const CorrectedFraction& one : summary.schemes.front().fractions) {
      const double fraction = truth[one.name];
      inside += one.corrected.interval.low <= fraction && fraction <= one.corrected.interval.high;
      ++all;
    }
    const Interval median =
        sizes_by(summary, SizeWeighting::kCorrected).percentiles[kI][kD50].interval;
    const double true_median = upper_median(sizes);
    medians += median.low <= true_median && true_median <= median.high;
  }
  EXPECT_GE(inside, static_cast<int>(0.91 * all));
  EXPECT_GE(medians, kDeposits - 4);
}

TEST(ScannedDeposit, FractionsSumToOne) {
  const ScannedDepositSummary summary = summary_of(sample_deposit(150, 4).found);
  for (const CorrectedSchemeFractions& scheme : summary.schemes) {
    double found = 0.0, corrected = 0.0;
    for (const CorrectedFraction& one : scheme.fractions) {
      found += one.found.value;
      corrected += one.corrected.value;
    }
    EXPECT_NEAR(found, 1.0, 1e-9);
    EXPECT_NEAR(corrected, 1.0, 1e-9);
  }
}

TEST(ScannedDeposit, BlocksThatAreNoneHardlyCount) {
  SampledDeposit deposit = sample_deposit(200, 5);
  MeasuredBlock wrong = deposit.found.blocks.front();
  wrong.axes = {60.0, 50.0, 40.0};
  wrong.deposit->lower_axes = wrong.deposit->upper_axes = wrong.axes;
  wrong.deposit->confidence = 0.01;
  const double before =
      sizes_by(summary_of(deposit.found), SizeWeighting::kNumber).percentiles[kI][kD50].value;
  deposit.found.blocks.push_back(wrong);
  const ScannedDepositSummary summary = summary_of(deposit.found);
  EXPECT_NEAR(sizes_by(summary, SizeWeighting::kNumber).percentiles[kI][kD50].value, before,
              0.03 * before);
  EXPECT_LT(summary.expected_blocks, static_cast<double>(summary.blocks) - 0.98);
}

TEST(ScannedDeposit, GivesTheSameBitsOnAnyNumberOfThreads) {
  const Population found = sample_deposit(60, 6).found;
  const ScannedDepositSummary one = summary_of(found, 1), three = summary_of(found, 3);
  for (std::size_t w = 0; w < kSizeWeightings.size(); ++w) {
    for (std::size_t q = 0; q < kWeightedQuantities.size(); ++q) {
      for (std::size_t p = 0; p < kWeightedPercentiles.size(); ++p) {
        const EstimatedValue &a = one.sizes[w].percentiles[q][p],
                             &b = three.sizes[w].percentiles[q][p];
        EXPECT_EQ(a.interval.low, b.interval.low);
        EXPECT_EQ(a.interval.high, b.interval.high);
      }
    }
  }
}

}  // namespace
}  // namespace clast
