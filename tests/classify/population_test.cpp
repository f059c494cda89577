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

}  // namespace
}  // namespace clast
