// Monotone trends of clustered values over a property of units.
#include "core/statistics/clustered_trend.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/random.hpp"
#include "tests/support/refusal.hpp"

namespace clast {
namespace {

/// What the values of a study are made of.
struct TrendStudy {
  std::uint32_t units = 12, points = 5, each = 3;
  double slope = 0.0;    ///< over the range of the property
  double of_unit = 1.0;  ///< standard deviations
  double of_point = 3.0;
  double of_run = 1.0;
  std::uint32_t strata = 1;
};

TrendSample trend_sample(const TrendStudy& study, Random& random) {
  TrendSample sample;
  std::vector<double> of_unit, of_point;
  for (std::uint32_t u = 0; u < study.units; ++u) {
    sample.property.push_back(random.uniform());
    sample.strata.push_back(u % study.strata);
    of_unit.push_back(study.slope * sample.property[u] + study.of_unit * random.normal() +
                      10.0 * sample.strata[u]);
  }
  for (std::uint32_t p = 0; p < study.points; ++p) {
    of_point.push_back(study.of_point * random.normal());
  }
  for (std::uint32_t u = 0; u < study.units; ++u) {
    for (std::uint32_t p = 0; p < study.points; ++p) {
      for (std::uint32_t k = 0; k < study.each; ++k) {
        sample.values.push_back(of_unit[u] + of_point[p] + study.of_run * random.normal());
        sample.units.push_back(u);
        sample.clusters.push_back(p);
      }
    }
  }
  return sample;
}

/// Share of 400 studies in which a trend is found at 5 %.
double found_share(const TrendStudy& study) {
  Random random(5);
  int found = 0;
  for (std::uint64_t i = 0; i < 400; ++i) {
    const auto result = clustered_trend_test(trend_sample(study, random), i, 399);
    found += result && result->p_value < 0.05 ? 1 : 0;
  }
  return found / 400.0;
}

// By hand: ranks of the property 1 2 3 4, mean ranks of the outcome in order 1 2 4 3: rho = 0.8,
// and 8 of 24 orders are as far from zero (0.8 or more either way): those of Spearman's table.
TEST(ClusteredTrend, OfFourUnitsIsSpearmansTestOfTheirMeanRanks) {
  const TrendSample sample{{10, 20, 40, 30, 110, 120, 140, 130},
                           {0, 0, 0, 0, 1, 1, 1, 1},
                           {0, 1, 2, 3, 0, 1, 2, 3},
                           {0.1, 0.2, 0.3, 0.4},
                           {0, 0, 0, 0}};
  const auto result = clustered_trend_test(sample, 1);
  ASSERT_TRUE(result);
  EXPECT_TRUE(result->exact);
  EXPECT_NEAR(result->statistic, 0.8, 1e-12);
  EXPECT_NEAR(result->p_value, 8.0 / 24.0, 1e-12);
}

// Page's L is the sum over subjects of rank times condition: ten strata of three units in the same
// order have the largest, and (1/6)^10 orders of each are as far in either direction.
TEST(ClusteredTrend, OfStrataIsPagesTest) {
  TrendSample sample;
  for (std::uint32_t stratum = 0; stratum < 10; ++stratum) {
    for (std::uint32_t k = 0; k < 3; ++k) {
      sample.property.push_back(k);
      sample.strata.push_back(stratum);
      sample.units.push_back(3 * stratum + k);
      sample.clusters.push_back(stratum);
      sample.values.push_back(100.0 * stratum + k);
    }
  }
  const auto result = clustered_trend_test(sample, 1, 999);
  ASSERT_TRUE(result);
  EXPECT_NEAR(result->statistic, 1.0, 1e-12);
  EXPECT_NEAR(result->p_value, 1.0 / 1000.0, 1e-12);
}

// Of 400 studies without a trend a test at 5 % finds 5 %, known to 1.1 %; runs of a block, and
// those of a point, are anything but independent.
TEST(ClusteredTrend, HoldsItsLevelWhereRunsOfABlockAndOfAPointBelongTogether) {
  EXPECT_NEAR(found_share({}), 0.05, 0.03);
  EXPECT_NEAR(found_share({.units = 7, .of_unit = 3.0}), 0.05, 0.03);
  EXPECT_NEAR(found_share({.units = 24, .of_unit = 2.0, .strata = 6}), 0.05, 0.03);
}

TEST(ClusteredTrend, IsFoundWhereThereIsOne) {
  EXPECT_GT(found_share({.slope = 6.0}), 0.95);
  EXPECT_GT(found_share({.units = 24, .slope = 8.0, .strata = 6}), 0.95);
}

TEST(ClusteredTrend, IsNoneWithoutUnitsThatDiffer) {
  TrendSample sample{{1, 2, 3}, {0, 0, 0}, {0, 1, 2}, {0.5, 0.5, 0.5}, {0, 0, 0}};
  EXPECT_FALSE(clustered_trend_test(sample, 1));
  sample.property = {0.1, 0.2, 0.3};
  sample.values = {2, 2, 2};
  EXPECT_FALSE(clustered_trend_test(sample, 1));
  sample.units[2] = 7;
  EXPECT_TRUE(
      contains(refusal([&] { clustered_trend_test(sample, 1); }), "no unit number 7 among 3"));
  sample.clusters.pop_back();
  EXPECT_TRUE(contains(refusal([&] { clustered_trend_test(sample, 1); }), "each of its 3 values"));
}

}  // namespace
}  // namespace clast
