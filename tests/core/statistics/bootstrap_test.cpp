#include "core/statistics/bootstrap.hpp"
#include "core/statistics/contrast.hpp"
#include "core/statistics/effect_sizes.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/random.hpp"

namespace clast {
namespace {

TEST(Holm, CorrectsAsByHand) {
  // 4 x 0.01, 3 x 0.02 and 2 x 0.03 both give 0.06, 1 x 0.2.
  const std::vector<double> corrected = holm_adjusted(std::vector<double>{0.03, 0.01, 0.2, 0.02});
  const std::vector<double> expected = {0.06, 0.04, 0.2, 0.06};
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(corrected[i], expected[i], 1e-15);
  // Never below one that was smaller before, never above one.
  const std::vector<double> near = holm_adjusted(std::vector<double>{0.3, 0.29, 0.9});
  EXPECT_NEAR(near[1], 0.87, 1e-15);
  EXPECT_NEAR(near[0], 0.87, 1e-15);
  EXPECT_NEAR(near[2], 0.9, 1e-15);
  EXPECT_TRUE(holm_adjusted({}).empty());
}

TEST(CliffsDelta, CountsPairs) {
  const std::vector<double> a = {1, 2, 3}, b = {2, 4};
  // Pairs: 1<2 1<4 2=2 2<4 3>2 3<4: one above, four below, of six.
  EXPECT_NEAR(*cliffs_delta(a, b), -0.5, 1e-15);
  EXPECT_NEAR(*cliffs_delta(b, a), 0.5, 1e-15);
  EXPECT_NEAR(*cliffs_delta(a, a), 0.0, 1e-15);
  EXPECT_EQ(*cliffs_delta(std::vector<double>{5, 6}, a), 1.0);
  EXPECT_FALSE(cliffs_delta(a, {}));
  EXPECT_STREQ(describe_cliffs_delta(-0.1), "negligible");
  EXPECT_STREQ(describe_cliffs_delta(0.2), "small");
  EXPECT_STREQ(describe_cliffs_delta(-0.4), "medium");
  EXPECT_STREQ(describe_cliffs_delta(0.9), "large");
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
  const Interval interval = *bootstrap_difference_interval(a, b, 1, 5);
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
  const Interval interval = *bootstrap_difference_interval(a, b, 20, 5);
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
  const Interval few = *bootstrap_difference_interval(few_a, few_b, 40, 7);
  const Interval many = *bootstrap_difference_interval(many_a, many_b, 40, 7);
  EXPECT_NEAR(many.low, few.low, 1e-12);
  EXPECT_NEAR(many.high, few.high, 1e-12);
}

TEST(Bootstrap, MeanOfOneClusterHasTheIntervalOfTheNormal) {
  Random random(11);
  ClusteredValues values;
  for (int i = 0; i < 400; ++i) {
    values.values.push_back(7.0 + 2.0 * random.normal());
    values.clusters.push_back(0);
  }
  const Interval interval = *bootstrap_mean_interval(values, 1, 5);
  const double width = 2 * 1.96 * 2.0 / std::sqrt(400.0);
  EXPECT_NEAR(interval.high - interval.low, width, 0.12 * width);
  EXPECT_FALSE(bootstrap_mean_interval({}, 1, 5));
}

TEST(Bootstrap, MeanOfRepeatedValuesIsNoSurerThanThatOfEachOnce) {
  Random random(12);
  ClusteredValues once, repeated;
  for (std::uint32_t cluster = 0; cluster < 25; ++cluster) {
    const double value = random.normal();
    once.values.push_back(value);
    once.clusters.push_back(cluster);
    for (int i = 0; i < 8; ++i) {
      repeated.values.push_back(value);
      repeated.clusters.push_back(cluster);
    }
  }
  const Interval a = *bootstrap_mean_interval(once, 25, 3),
                 b = *bootstrap_mean_interval(repeated, 25, 3);
  EXPECT_NEAR(a.low, b.low, 1e-12);
  EXPECT_NEAR(a.high, b.high, 1e-12);
}

TEST(ClusteredShare, RepeatedTrialsCountOnce) {
  ClusteredValues repeated;
  for (std::uint32_t cluster = 0; cluster < 40; ++cluster) {
    for (int i = 0; i < 10; ++i) {
      repeated.values.push_back(cluster < 12 ? 1.0 : 0.0);
      repeated.clusters.push_back(cluster);
    }
  }
  // The variance of 40 clusters is taken with 39: it is worth 39 trials.
  const Interval found = clustered_proportion_interval(repeated, 40);
  const Interval expected = wilson_interval_of_proportion(0.3, 39.0);
  EXPECT_NEAR(found.low, expected.low, 1e-12);
  EXPECT_NEAR(found.high, expected.high, 1e-12);
}

TEST(ClusteredShare, IsWilsonsWhereThereIsNothingToLearnFromClusters) {
  ClusteredValues none, one, even;
  for (std::uint32_t i = 0; i < 60; ++i) {
    none.values.push_back(0.0);
    none.clusters.push_back(i % 6);
    one.values.push_back(i < 20 ? 1.0 : 0.0);
    one.clusters.push_back(0);
    even.values.push_back(i % 2);  // the same share in each cluster: no surer than runs alone
    even.clusters.push_back(i / 10);
  }
  EXPECT_EQ(clustered_proportion_interval(none, 6).high, wilson_interval(0, 60).high);
  EXPECT_EQ(clustered_proportion_interval(one, 1).low, wilson_interval(20, 60).low);
  EXPECT_EQ(clustered_proportion_interval(even, 6).low, wilson_interval(30, 60).low);
  EXPECT_EQ(clustered_proportion_interval({}, 3).high, 1.0);
}

TEST(ClusteredShare, CoversTheTruthNineteenTimesInTwenty) {
  // 30 clusters of 10 trials whose chance is drawn for each cluster, 0.1 or 0.7.
  Random random(21);
  int covered = 0, by_runs = 0;
  for (int study = 0; study < 400; ++study) {
    ClusteredValues hits;
    std::size_t count = 0;
    for (std::uint32_t cluster = 0; cluster < 30; ++cluster) {
      const double chance = random.uniform() < 0.5 ? 0.1 : 0.7;
      for (int i = 0; i < 10; ++i) {
        hits.values.push_back(random.uniform() < chance ? 1.0 : 0.0);
        hits.clusters.push_back(cluster);
        count += hits.values.back() > 0.0;
      }
    }
    const auto holds = [](const Interval& interval) {
      return interval.low <= 0.4 && 0.4 <= interval.high;
    };
    covered += holds(clustered_proportion_interval(hits, 30));
    by_runs += holds(wilson_interval(count, 300));
  }
  EXPECT_GE(covered, 368);  // 380 of 400 less three standard deviations
  EXPECT_LE(by_runs, 340) << "runs taken as independent promise too much";
}

TEST(Bootstrap, GroupsThatAreEmptyHaveNoInterval) {
  const ClusteredValues one{{1.0}, {0}};
  EXPECT_FALSE(bootstrap_difference_interval(one, {}, 1, 1));
}

}  // namespace
}  // namespace clast
