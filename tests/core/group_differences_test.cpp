#include "core/group_differences.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/random.hpp"

namespace clast {
namespace {

TEST(Holm, CorrectsAsByHand) {
  // 4 x 0.01, 3 x 0.02 and 2 x 0.03 both give 0.06, 1 x 0.2.
  const std::vector<double> corrected = holm(std::vector<double>{0.03, 0.01, 0.2, 0.02});
  const std::vector<double> expected = {0.06, 0.04, 0.2, 0.06};
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(corrected[i], expected[i], 1e-15);
  // Never below one that was smaller before, never above one.
  const std::vector<double> near = holm(std::vector<double>{0.3, 0.29, 0.9});
  EXPECT_NEAR(near[1], 0.87, 1e-15);
  EXPECT_NEAR(near[0], 0.87, 1e-15);
  EXPECT_NEAR(near[2], 0.9, 1e-15);
  EXPECT_TRUE(holm({}).empty());
}

TEST(CliffsDelta, CountsPairs) {
  const std::vector<double> a = {1, 2, 3}, b = {2, 4};
  // Pairs: 1<2 1<4 2=2 2<4 3>2 3<4: one above, four below, of six.
  EXPECT_NEAR(*cliffs_delta(a, b), -0.5, 1e-15);
  EXPECT_NEAR(*cliffs_delta(b, a), 0.5, 1e-15);
  EXPECT_NEAR(*cliffs_delta(a, a), 0.0, 1e-15);
  EXPECT_EQ(*cliffs_delta(std::vector<double>{5, 6}, a), 1.0);
  EXPECT_FALSE(cliffs_delta(a, {}));
  EXPECT_STREQ(words_for_delta(-0.1), "negligible");
  EXPECT_STREQ(words_for_delta(0.2), "small");
  EXPECT_STREQ(words_for_delta(-0.4), "medium");
  EXPECT_STREQ(words_for_delta(0.9), "large");
}

TEST(HedgesG, IsTheFormula) {
  const std::vector<double> a = {1, 2, 3}, b = {2, 4, 6, 8};
  // Means 2 and 5, squares 2 and 20 about them, 5 degrees of freedom.
  EXPECT_NEAR(*hedges_g(a, b), (1 - 3.0 / 19) * -3 / std::sqrt(22.0 / 5), 1e-14);
  EXPECT_FALSE(hedges_g(a, std::vector<double>{1}));
  EXPECT_FALSE(hedges_g(std::vector<double>{2, 2}, std::vector<double>{1, 1}));
}

TEST(Bootstrap, OfOneClusterHasTheWidthOfTheStandardError) {
  Random random(1);
  ClusteredValues a, b;
  for (int i = 0; i < 400; ++i) {
    a.values.push_back(3.0 + random.normal());
    b.values.push_back(1.0 + 2.0 * random.normal());
    a.clusters.push_back(0);
    b.clusters.push_back(0);
  }
  const Interval interval = *bootstrap_difference(a, b, 1, 5);
  const double width = 2 * 1.96 * std::sqrt((1.0 + 4.0) / 400);
  EXPECT_NEAR(interval.high - interval.low, width, 0.12 * width);
  EXPECT_LT(interval.low, 2.0);
  EXPECT_GT(interval.high, 2.0);
}

TEST(Bootstrap, WhatAClusterShiftsInBothGroupsIsNoDifference) {
  // 20 places, each far from the others; at each, b is 1 above a, give or take 0.1.
  Random random(2);
  ClusteredValues a, b;
  for (std::uint32_t cluster = 0; cluster < 20; ++cluster) {
    const double place = 50.0 * random.normal();
    for (int i = 0; i < 10; ++i) {
      a.values.push_back(place + 0.1 * random.normal());
      b.values.push_back(place + 1.0 + 0.1 * random.normal());
      a.clusters.push_back(cluster);
      b.clusters.push_back(cluster);
    }
  }
  const Interval interval = *bootstrap_difference(a, b, 20, 5);
  EXPECT_NEAR(interval.low, -1.0, 0.05);
  EXPECT_NEAR(interval.high, -1.0, 0.05);
}

TEST(Bootstrap, ClustersThatDifferWidenTheInterval) {
  // Every value counted ten times, as runs of one place are: the interval is that of 20 values.
  Random random(3);
  ClusteredValues few_a, few_b, many_a, many_b;
  for (std::uint32_t cluster = 0; cluster < 40; ++cluster) {
    const double value = random.normal();
    ClusteredValues& few = cluster < 20 ? few_a : few_b;
    ClusteredValues& many = cluster < 20 ? many_a : many_b;
    few.values.push_back(value);
    few.clusters.push_back(cluster);
    for (int i = 0; i < 10; ++i) {
      many.values.push_back(value);
      many.clusters.push_back(cluster);
    }
  }
  const Interval few = *bootstrap_difference(few_a, few_b, 40, 7);
  const Interval many = *bootstrap_difference(many_a, many_b, 40, 7);
  EXPECT_NEAR(many.low, few.low, 1e-12);
  EXPECT_NEAR(many.high, few.high, 1e-12);
}

TEST(Bootstrap, GroupsThatAreEmptyHaveNoInterval) {
  const ClusteredValues one{{1.0}, {0}};
  EXPECT_FALSE(bootstrap_difference(one, {}, 1, 1));
}

}  // namespace
}  // namespace clast
