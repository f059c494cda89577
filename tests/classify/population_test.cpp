#include "classify/population.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/error.hpp"

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
    const auto shares = class_shares(population(a, b), "garcia");
    ASSERT_EQ(shares.size(), 2u);
    const double n = a + b;
    for (const ClassShare& share : shares) {
      EXPECT_EQ(share.share, share.count / n);
      for (const double limit : {share.low, share.high}) {
        const double error = std::sqrt(limit * (1.0 - limit) / n);
        EXPECT_NEAR(std::abs(share.share - limit) / error, 1.959964, 1e-5);
      }
      EXPECT_LT(share.low, share.share);
      EXPECT_GT(share.high, share.share);
    }
  }
}

// 0 of 10: upper limit z^2 / (n + z^2) = 3.8415 / 13.8415.
TEST(ClassShares, EmptyClassesKeepAnUpperLimit) {
  const auto shares = class_shares(population(10, 0), "garcia");
  EXPECT_EQ(shares[0].name, "compact");
  EXPECT_EQ(shares[0].count, 10u);
  EXPECT_EQ(shares[0].high, 1.0);
  EXPECT_NEAR(shares[0].low, 1.0 - 3.841459 / 13.841459, 1e-6);
  EXPECT_EQ(shares[1].count, 0u);
  EXPECT_EQ(shares[1].low, 0.0);
  EXPECT_NEAR(shares[1].high, 3.841459 / 13.841459, 1e-6);
}

TEST(ClassShares, EveryClassIsListedAndCountsAddUp) {
  const auto shares = class_shares(population(3, 4), "sneed-folk");
  EXPECT_EQ(shares.size(), 10u);
  std::size_t total = 0;
  for (const ClassShare& share : shares) total += share.count;
  EXPECT_EQ(total, 7u);
}

TEST(ClassShares, OfNoBlocksNothingIsKnown) {
  for (const ClassShare& share : class_shares({}, "zingg")) {
    EXPECT_EQ(share.count, 0u);
    EXPECT_EQ(share.low, 0.0);
    EXPECT_EQ(share.high, 1.0);
  }
}

TEST(ClassShares, UnknownSchemeIsRefused) {
  EXPECT_THROW(class_shares(population(1, 1), "none"), InputError);
}

TEST(ClassShares, ByMassCountKilograms) {
  const std::vector<double> masses = {1.0, 2.0, 5.0};
  const auto shares = class_shares(population(2, 1), "garcia", {}, masses);
  EXPECT_NEAR(*shares[0].mass_share, 3.0 / 8.0, 1e-15);
  EXPECT_NEAR(*shares[1].mass_share, 5.0 / 8.0, 1e-15);
  EXPECT_FALSE(class_shares(population(2, 1), "garcia")[0].mass_share.has_value());
}

TEST(Population, C40CountsSlabs) {
  const std::vector<Axes> blocks = {{1, 1, 0.4}, {1, 1, 0.41}, {1.1, 0.6, 0.44}, {1, 0.5, 0.1}};
  EXPECT_EQ(c40(blocks), 0.75);
}

TEST(Population, ComparedWithItselfDoesNotDiffer) {
  const auto blocks = population(20, 15);
  const PopulationComparison same = compared(blocks, blocks, "sneed-folk");
  EXPECT_EQ(same.s_c.p_value, 1.0);
  EXPECT_EQ(same.classes.statistic, 0.0);
  EXPECT_TRUE(in_words("classes", same.classes).find("can't be told apart") != std::string::npos);
}

TEST(Population, ComparedWithAnotherDiffersInWords) {
  const PopulationComparison other = compared(population(40, 5), population(5, 40), "garcia");
  EXPECT_NEAR(other.s_c.statistic, 35.0 / 45.0, 1e-15);
  EXPECT_EQ(other.classes.degrees, 1u);
  EXPECT_LT(other.classes.p_value, 1e-6);
  EXPECT_EQ(in_words("s_c", other.s_c), "s_c differ (Kolmogorov-Smirnov D = 0.778, p < 0.0001)");
  // Cubes have no disc-rod index; with none of them on one side nothing is said.
  EXPECT_EQ(compared(population(5, 0), population(5, 5), "zingg").disc_rod_index.p_value, 1.0);
}

}  // namespace
}  // namespace clast
