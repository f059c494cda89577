// Fabric and sorting, against boxes placed by hand and probabilities counted out.
#include "study/deposit_fabric.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "tests/study/boxes_that_stay.hpp"

namespace clast {
namespace {

constexpr double kDegree = kPi / 180.0;

void turn(CampaignResults& results, std::size_t run, double degrees) {
  results.runs[run].result.final_state.orientation =
      Quat(Eigen::AngleAxisd(degrees * kDegree, Vec3::UnitZ()));
}

const FabricGroup& group_named(const DepositFabric& fabric, const std::string& name) {
  for (const FabricGroup& group : fabric.groups) {
    if (group.name == name) return group;
  }
  throw std::out_of_range(name);
}

const SortingTrend& trend_of(const DepositFabric& fabric, const std::string& property,
                             const std::string& place) {
  for (const SortingTrend& trend : fabric.sorting) {
    if (trend.property == property && trend.place == place) return trend;
  }
  throw std::out_of_range(property + " and " + place);
}

TEST(DepositFabric, HasTheAxialMeanOfTheLongAxes) {
  CampaignResults results = boxes_that_stay();
  // To the right of downslope is -y: trends are 65 and 95 degrees, three times each.
  for (std::size_t run = 0; run < 6; ++run) turn(results, run, run % 2 == 0 ? -65.0 : 180.0 - 95.0);
  const DepositFabric fabric = deposit_fabric(compared(std::move(results)));
  const FabricGroup& all = group_named(fabric, "all");
  EXPECT_EQ(all.blocks, 6u);
  EXPECT_EQ(all.realisations, 2u);
  EXPECT_NEAR(all.trend.direction, 80.0 * kDegree, 1e-9);
  EXPECT_NEAR(all.trend.resultant, std::sqrt(3.0) / 2.0, 1e-9);
  EXPECT_NEAR(*all.rayleigh, rayleigh_p({6, 0.0, std::sqrt(3.0) / 2.0}), 1e-9);
  ASSERT_TRUE(all.rayleigh_realisations);
  EXPECT_NEAR(all.plunge, 0.0, 1e-9);
  // Of a a': (1 + cos 30)/2 along the mean, (1 - cos 30)/2 across, nothing upwards.
  EXPECT_NEAR(all.eigenvalues[0], 0.5 + std::sqrt(3.0) / 4.0, 1e-9);
  EXPECT_NEAR(all.eigenvalues[1], 0.5 - std::sqrt(3.0) / 4.0, 1e-9);
  EXPECT_NEAR(all.eigenvalues[2], 0.0, 1e-9);
}

TEST(DepositFabric, SaysWhereClassesAndSizesLie) {
  CampaignResults results = boxes_that_stay();
  results.blocks.resize(3, results.blocks[0]);
  results.blocks[2] = results.blocks[0];
  for (std::size_t i = 0; i < 3; ++i) results.blocks[i].volume = 1.0 + static_cast<double>(i);
  for (std::size_t run = 0; run < 6; ++run) {
    results.runs[run].block = static_cast<std::uint32_t>(run % 3);
  }
  // The second realisation went 1 m farther as a whole.
  for (std::size_t run = 3; run < 6; ++run) {
    results.runs[run].result.final_state.position.x() += 1.0;
  }
  const DepositFabric fabric = deposit_fabric(compared(std::move(results)));
  const FabricGroup& smallest = group_named(fabric, "smallest third");
  EXPECT_EQ(smallest.blocks, 2u);
  EXPECT_NEAR(smallest.along.summary.mean, 10.5, 1e-6);
  ASSERT_TRUE(smallest.along.interval);
  // Half a metre to either side of the mean: t of one degree of freedom is tan(0.475 pi).
  EXPECT_NEAR(smallest.along.interval->high - 10.5, 0.5 * std::tan(0.475 * kPi), 1e-5);
  EXPECT_NEAR(smallest.ahead.summary.mean, -4.0, 1e-6);
  EXPECT_NEAR(group_named(fabric, "largest third").ahead.summary.mean, 4.0, 1e-6);
  EXPECT_NEAR(group_named(fabric, "middle third").ahead.summary.mean, 0.0, 1e-6);
  EXPECT_NEAR(group_named(fabric, "class elongated").ahead.summary.mean, 0.0, 1e-6);
  EXPECT_NEAR(group_named(fabric, "all").relative_height.summary.mean, 0.5, 1e-9);
  // The larger a block, the farther it is: in each realisation without exception.
  const SortingTrend& runout = trend_of(fabric, "volume", "runout");
  EXPECT_EQ(runout.rank_correlation.summary.count, 2u);
  EXPECT_EQ(runout.rank_correlation.summary.mean, 1.0);
  EXPECT_FALSE(runout.p_value) << "realisations do not differ";
  EXPECT_THROW(trend_of(fabric, "I/L", "runout"), std::out_of_range) << "all boxes are alike";
}

TEST(DepositFabric, AveragesRankCorrelationsOverRealisations) {
  CampaignResults results = boxes_that_stay();
  results.blocks.resize(3, results.blocks[0]);
  for (std::size_t i = 0; i < 3; ++i) results.blocks[i].volume = 1.0 + static_cast<double>(i);
  // Ranks 1 2 3 in the first realisation and 2 1 3 in the second: 1 and 1 - 6 * 2/24 = 0.5.
  for (std::size_t run = 0; run < 6; ++run) {
    results.runs[run].block = static_cast<std::uint32_t>(run % 3);
  }
  std::swap(results.runs[3].block, results.runs[4].block);
  const DepositFabric fabric = deposit_fabric(compared(std::move(results)));
  const SortingTrend& trend = trend_of(fabric, "volume", "ahead");
  EXPECT_NEAR(trend.rank_correlation.summary.mean, 0.75, 1e-12);
  ASSERT_TRUE(trend.rank_correlation.interval && trend.p_value);
  // 0.25 tan(0.475 pi) to either side is more than a correlation can be.
  EXPECT_EQ(trend.rank_correlation.interval->low, -1.0);
  EXPECT_EQ(trend.rank_correlation.interval->high, 1.0);
  // t = 0.75/0.25 with one degree of freedom: P(|T| > t) = 1 - 2 atan(t)/pi.
  EXPECT_NEAR(*trend.p_value, 1.0 - 2.0 * std::atan(3.0) / kPi, 1e-9);
}

TEST(SameClassTest, HasTheProbabilityOfAllWaysToDeal) {
  // Two pairs of neighbours, two blocks of each class: the pairs are equal in two ways of six, and
  // mixed in four, which are nearer to the expected third.
  const NeighbourTest test = same_class_test({{0, 0, 1, 1}, {1, 0, 3, 2}, {0, 0, 0, 0}}, 1);
  EXPECT_EQ(test.share, 1.0);
  EXPECT_NEAR(test.expected, 1.0 / 3.0, 1e-12);
  EXPECT_NEAR(*test.p_value, 1.0 / 3.0, 0.02);
  const NeighbourTest mixed = same_class_test({{0, 1, 0, 1}, {1, 0, 3, 2}, {0, 0, 0, 0}}, 1);
  EXPECT_EQ(mixed.share, 0.0);
  EXPECT_EQ(mixed.p_value, 1.0);
}

TEST(SameClassTest, ExchangesWithinRealisationsOnly) {
  // Each realisation has one class: there is nothing to exchange.
  const NeighbourTest test = same_class_test({{0, 0, 1, 1}, {1, 0, 3, 2}, {0, 0, 1, 1}}, 1);
  EXPECT_EQ(test.realisations, 2u);
  EXPECT_EQ(test.share, 1.0);
  EXPECT_NEAR(test.expected, 1.0, 1e-12);
  EXPECT_EQ(test.p_value, 1.0);
}

TEST(SameClassTest, FindsClassesThatLieTogether) {
  PairedClasses pairs;
  for (std::size_t i = 0; i < 40; ++i) {
    pairs.classes.push_back(i < 20 ? 0 : 1);
    pairs.partners.push_back(i % 2 == 0 ? i + 1 : i - 1);
    pairs.strata.push_back(0);
  }
  EXPECT_LT(*same_class_test(pairs, 1).p_value, 0.001);
  EXPECT_EQ(same_class_test(pairs, 1).p_value, same_class_test(pairs, 1).p_value);
  EXPECT_TRUE(std::isnan(same_class_test({}, 1).share));
}

TEST(DepositFabric, IsNoneWhereNoBlockStayed) {
  const DepositFabric fabric = deposit_fabric(compared(hand_made_results()));
  EXPECT_TRUE(fabric.groups.empty());
  EXPECT_TRUE(fabric.neighbours.empty());
  EXPECT_TRUE(fabric.sorting.empty());
}

}  // namespace
}  // namespace clast
