#include "core/statistics/clustered_test.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>

#include "core/random.hpp"

namespace clast {
namespace {

struct Pair {
  ClusteredValues a, b;
};

void add(ClusteredValues& sample, double value, std::uint32_t cluster) {
  sample.values.push_back(value);
  sample.clusters.push_back(cluster);
}

TEST(ClusteredKs, OfOneClusterIsTheTestOfSingleValues) {
  Pair pair;
  for (const double value : {1.0, 2.0, 3.5, 4.0}) add(pair.a, value, 0);
  for (const double value : {3.0, 5.0, 6.0, 7.0, 8.0}) add(pair.b, value, 0);
  const TestResult found = *clustered_ks_test(pair.a, pair.b, 1, 3);
  const TestResult single = *two_sample_ks_test(pair.a.values, pair.b.values);
  EXPECT_EQ(found.statistic, single.statistic);
  EXPECT_EQ(found.p_value, single.p_value);
  EXPECT_FALSE(clustered_ks_test(pair.a, {}, 1, 3));
}

// Two points with five and four values, of which the first sample has three and two: 10 x 6 deals,
// each looked at.
TEST(ClusteredKs, DealsWithinClusters) {
  const std::vector<double> values = {1.0, 2.0, 3.0, 4.0, 5.0, 3.5, 11.0, 12.0, 13.0};
  const auto dealt = [&](unsigned to_first) {
    Pair pair;
    for (unsigned i = 0; i < 9; ++i) {
      add((to_first >> i) % 2 == 1 ? pair.a : pair.b, values[i], i < 5 ? 0 : 1);
    }
    return pair;
  };
  const Pair found = dealt(0b001100111);  // 1, 2, 3 and 3.5, 11
  const double distance = two_sample_ks_test(found.a.values, found.b.values)->statistic;
  int deals = 0, as_far = 0;
  for (unsigned to_first = 0; to_first < 512; ++to_first) {
    if (std::popcount(to_first & 0b11111u) != 3 || std::popcount(to_first >> 5) != 2) continue;
    const Pair pair = dealt(to_first);
    ++deals;
    const double other = two_sample_ks_test(pair.a.values, pair.b.values)->statistic;
    as_far += other >= distance - 1e-12 ? 1 : 0;
  }
  ASSERT_EQ(deals, 60);
  const double exact = as_far / 60.0;
  ASSERT_GT(exact, 0.01);
  ASSERT_LT(exact, 0.5);
  const TestResult test = *clustered_ks_test(found.a, found.b, 2, 7);
  EXPECT_EQ(test.statistic, distance);
  EXPECT_FALSE(test.exact);
  EXPECT_NEAR(test.p_value, exact, 4.0 * std::sqrt(exact * (1.0 - exact) / 9999.0) + 1e-4);
}

// Eight points, far apart: a shift that the scatter between points hides from single values.
TEST(ClusteredKs, SeesWhatPointsHide) {
  int found = 0, found_in_single_values = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    Random random(seed);
    Pair pair;
    for (std::uint32_t point = 0; point < 8; ++point) {
      const double place = 30.0 * point;
      for (int i = 0; i < 12; ++i) {
        add(pair.a, place + random.normal(), point);
        add(pair.b, place + 3.0 + random.normal(), point);
      }
    }
    found += clustered_ks_test(pair.a, pair.b, 8, seed, 999)->p_value < 0.01 ? 1 : 0;
    found_in_single_values +=
        two_sample_ks_test(pair.a.values, pair.b.values)->p_value < 0.01 ? 1 : 0;
  }
  EXPECT_EQ(found_in_single_values, 0);
  EXPECT_EQ(found, 20);
}

/// Points at random places with some values each; a rule says which sample has a value, and nothing
/// else does it differ by.
template <class Rule>
Pair scattered(std::uint64_t seed, std::uint32_t points, int values, const Rule& to_first) {
  Random random(seed);
  Pair pair;
  for (std::uint32_t point = 0; point < points; ++point) {
    const double place = 3.0 * random.normal();
    for (int i = 0; i < values; ++i) {
      add(to_first(point, i) ? pair.a : pair.b, place + random.normal(), point);
    }
  }
  return pair;
}

// Groups that start from points of their own: what points do is no difference of groups.
TEST(ClusteredKs, TakesNoPointForAGroup) {
  int flagged = 0, flagged_by_single_values = 0;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const Pair pair = scattered(seed, 12, 10, [](std::uint32_t point, int) { return point < 6; });
    flagged += clustered_ks_test(pair.a, pair.b, 12, seed, 999)->p_value < 0.05 ? 1 : 0;
    flagged_by_single_values +=
        two_sample_ks_test(pair.a.values, pair.b.values)->p_value < 0.05 ? 1 : 0;
  }
  EXPECT_GE(flagged_by_single_values, 100);
  EXPECT_LE(flagged, 20);  // 10 expected, standard deviation 3.1
}

TEST(ClusteredKs, HasTheSizeItSaysWhereSomePointsAreShared) {
  int flagged = 0;
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    const Pair pair = scattered(1000 + seed, 9, 8, [](std::uint32_t point, int i) {
      return point < 3 || (point < 6 && i < 5);
    });
    flagged += clustered_ks_test(pair.a, pair.b, 9, seed, 499)->p_value < 0.05 ? 1 : 0;
  }
  EXPECT_GE(flagged, 8);  // 20 expected, standard deviation 4.4
  EXPECT_LE(flagged, 34);
}

}  // namespace
}  // namespace clast
