#include "classify/population.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/error.hpp"
#include "core/random.hpp"

namespace clast {
namespace {

std::vector<Axes> population(int compact, int elongated) {
  std::vector<Axes> blocks;
  for (int i = 0; i < compact; ++i) blocks.push_back({1.0, 1.0, 1.0});
  for (int i = 0; i < elongated; ++i) blocks.push_back({2.0, 1.0, 1.0});
  return blocks;
}

// Wilson's limits are the shares p0 for which the observed p is 1.96 standard errors of p0 away.
TEST(ClassShares, IntervalsSolveWilsonsEquation) {
  for (const auto& [a, b] : {std::pair{1, 9}, {10, 10}, {43, 46}, {99, 1}}) {
    const auto shares = class_fractions(population(a, b), "garcia");
    ASSERT_EQ(shares.size(), 2u);
    const double n = a + b;
    for (const ClassFraction& share : shares) {
      EXPECT_EQ(share.fraction, share.count / n);
      for (const double limit : {share.low, share.high}) {
        const double error = std::sqrt(limit * (1.0 - limit) / n);
        EXPECT_NEAR(std::abs(share.fraction - limit) / error, 1.959964, 1e-5);
      }
      EXPECT_LT(share.low, share.fraction);
      EXPECT_GT(share.high, share.fraction);
    }
  }
}

// 0 of 10: upper limit z^2 / (n + z^2) = 3.8415 / 13.8415.
TEST(ClassShares, EmptyClassesKeepAnUpperLimit) {
  const auto shares = class_fractions(population(10, 0), "garcia");
  EXPECT_EQ(shares[0].name, "compact");
  EXPECT_EQ(shares[0].count, 10u);
  EXPECT_EQ(shares[0].high, 1.0);
  EXPECT_NEAR(shares[0].low, 1.0 - 3.841459 / 13.841459, 1e-6);
  EXPECT_EQ(shares[1].count, 0u);
  EXPECT_EQ(shares[1].low, 0.0);
  EXPECT_NEAR(shares[1].high, 3.841459 / 13.841459, 1e-6);
}

TEST(ClassShares, EveryClassIsListedAndCountsAddUp) {
  const auto shares = class_fractions(population(3, 4), "sneed-folk");
  EXPECT_EQ(shares.size(), 10u);
  std::size_t total = 0;
  for (const ClassFraction& share : shares) total += share.count;
  EXPECT_EQ(total, 7u);
}

TEST(ClassShares, OfNoBlocksNothingIsKnown) {
  for (const ClassFraction& share : class_fractions({}, "zingg")) {
    EXPECT_EQ(share.count, 0u);
    EXPECT_EQ(share.low, 0.0);
    EXPECT_EQ(share.high, 1.0);
  }
}

TEST(ClassShares, EqualMassesGiveTheSharesByNumber) {
  const auto blocks = population(43, 46);
  const std::vector<double> kg(89, 250.0);
  for (const ClassFraction& share : class_fractions(blocks, "garcia", {}, kg)) {
    EXPECT_NEAR(share.mass_fraction, share.fraction, 1e-14);
    EXPECT_NEAR(share.mass_low, share.low, 1e-12);
    EXPECT_NEAR(share.mass_high, share.high, 1e-12);
    EXPECT_EQ(share.mass, 250.0 * static_cast<double>(share.count));
  }
}

TEST(ClassShares, OneHeavyBlockSaysLittleOfTheDeposit) {
  // 9 blocks of 1 kg and one of 91: by mass the sample is worth 100^2/(9 + 91^2) = 1.2 blocks.
  const auto blocks = population(9, 1);
  std::vector<double> kg(9, 1.0);
  kg.push_back(91.0);
  const auto shares = class_fractions(blocks, "garcia", {}, kg);
  EXPECT_NEAR(shares[1].mass_fraction, 0.91, 1e-14);
  EXPECT_LT(shares[1].mass_low, 0.35);
  EXPECT_NEAR(shares[0].mass_low, 1.0 - shares[1].mass_high, 1e-12);
}

TEST(ClassShares, BlocksWithoutMassCountByNumberOnly) {
  const auto shares =
      class_fractions(population(2, 2), "garcia", {}, std::vector<double>{30, 0, 10, 0});
  EXPECT_EQ(shares[0].count, 2u);
  EXPECT_EQ(shares[0].fraction, 0.5);
  EXPECT_EQ(shares[0].mass, 30.0);
  EXPECT_EQ(shares[0].mass_fraction, 0.75);
  const auto none = class_fractions(population(2, 2), "garcia");
  EXPECT_EQ(none[0].mass_fraction, 0.0);
  EXPECT_EQ(none[0].mass_low, 0.0);
  EXPECT_EQ(none[0].mass_high, 1.0);
}

// Deposits where elongated blocks are 30 % of the number but of another mass: the interval by mass
// holds the deposit's true share in about 95 % of samples of 89 blocks.
TEST(ClassShares, IntervalsByMassHoldTheTrueShare) {
  for (const double heavier : {0.5, 1.0, 2.0}) {
    const double truth = 0.3 * heavier / (0.3 * heavier + 0.7);
    Random random(5);
    int held = 0;
    constexpr int kSamples = 1500;
    for (int sample = 0; sample < kSamples; ++sample) {
      std::vector<Axes> blocks;
      std::vector<double> kg;
      for (int i = 0; i < 89; ++i) {
        const bool elongated = random.uniform() < 0.3;
        blocks.push_back({elongated ? 2.0 : 1.0, 1.0, 1.0});
        kg.push_back((elongated ? heavier : 1.0) * 600.0 * std::exp(0.8 * random.normal()));
      }
      const ClassFraction share = class_fractions(blocks, "garcia", {}, kg)[1];
      held += share.mass_low <= truth && truth <= share.mass_high;
    }
    EXPECT_GT(held, 0.92 * kSamples) << heavier;
    EXPECT_LT(held, 0.985 * kSamples) << heavier;
  }
}

TEST(ClassShares, UnknownSchemeIsRefused) {
  EXPECT_THROW(class_fractions(population(1, 1), "none"), InputError);
}

TEST(Population, C40CountsSlabs) {
  const std::vector<Axes> blocks = {{1, 1, 0.4}, {1, 1, 0.41}, {1.1, 0.6, 0.44}, {1, 0.5, 0.1}};
  EXPECT_EQ(c40_index(blocks), 0.75);
}

}  // namespace
}  // namespace clast
