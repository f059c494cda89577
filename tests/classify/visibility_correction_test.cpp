#include "classify/visibility_correction.hpp"

#include <gtest/gtest.h>

#include "classify/size_distribution.hpp"
#include "core/statistics/statistics.hpp"
#include "tests/classify/deposit_samples.hpp"

namespace clast {
namespace {

double true_median(const SampledDeposit& deposit) {
  std::vector<double> sizes;
  for (const Axes& axes : deposit.truth) sizes.push_back(axes.I);
  return upper_median(sizes);
}

/// Median I of the found blocks, with the weights of the correction or without.
double found_median(const SampledDeposit& deposit, const VisibilityCorrection* correction) {
  std::vector<double> sizes, weights;
  for (const MeasuredBlock& block : deposit.found.blocks) {
    sizes.push_back(block.axes.I);
    weights.push_back(correction ? 1.0 / correction->inclusion_probability(block.axes.I) : 1.0);
  }
  return weighted_percentile(sizes, weights, 0.5);
}

TEST(VisibilityCorrection, RemovesTheBiasOfTheMedianOfManyDeposits) {
  double without = 0.0, with = 0.0;
  constexpr int kDeposits = 12;
  for (int seed = 1; seed <= kDeposits; ++seed) {
    const SampledDeposit deposit = sample_deposit(200, static_cast<std::uint64_t>(seed));
    const VisibilityCorrection correction = fit_visibility_correction(deposit.found.blocks, 1);
    without += found_median(deposit, nullptr) / true_median(deposit) - 1.0;
    with += found_median(deposit, &correction) / true_median(deposit) - 1.0;
  }
  EXPECT_GT(without / kDeposits, 0.08);
  EXPECT_LT(std::abs(with / kDeposits), 0.04);
}

TEST(VisibilityCorrection, IsSmallWhereAllBlocksAreSeen) {
  const SampledDeposit deposit =
      sample_deposit(200, 5, {.mean_area = 2.0, .slope = 0.1, .deviation = 0.3, .spacing = 0.0177});
  const VisibilityCorrection correction = fit_visibility_correction(deposit.found.blocks, 1);
  for (const double size : {0.25, 0.5, 1.0}) {
    EXPECT_GT(correction.inclusion_probability(size), 0.9 * VisibilityCorrection::kMostFound);
    EXPECT_LE(correction.inclusion_probability(size), VisibilityCorrection::kMostFound);
  }
}

TEST(VisibilityCorrection, FewerSmallBlocksAreFoundWithFewerPoints) {
  const SampledDeposit dense = sample_deposit(300, 6);
  const SampledDeposit sparse = sample_deposit(300, 6, {.spacing = 0.0325});
  const auto probability = [](const SampledDeposit& deposit, double size) {
    return fit_visibility_correction(deposit.found.blocks, 1).inclusion_probability(size);
  };
  EXPECT_LT(probability(sparse, 0.3), 0.8 * probability(dense, 0.3));
  EXPECT_NEAR(probability(sparse, 1.5), probability(dense, 1.5), 0.1);
}

TEST(VisibilityCorrection, GivesTheSameBitsForTheSameSeed) {
  const SampledDeposit deposit = sample_deposit(100, 7);
  const VisibilityCorrection a = fit_visibility_correction(deposit.found.blocks, 3);
  const VisibilityCorrection b = fit_visibility_correction(deposit.found.blocks, 3);
  EXPECT_EQ(a.inclusion_probability(0.4), b.inclusion_probability(0.4));
  EXPECT_EQ(a.draws.size(), b.draws.size());
  EXPECT_EQ(a.with_draw(5).model.mean, b.draws[5].mean);
}

}  // namespace
}  // namespace clast
