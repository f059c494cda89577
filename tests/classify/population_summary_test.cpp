#include "classify/population_summary.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/random.hpp"
#include "tests/support/refusal.hpp"

namespace clast {
namespace {

/// Blocks with s_c about `s_c`; sizes rise with elongation where `related`.
Population deposit(const std::string& name, std::uint64_t seed, int blocks, double s_c,
                   bool related = false) {
  Random random(seed);
  Population population{name, {}};
  for (int i = 0; i < blocks; ++i) {
    const double elongation = s_c * std::exp(0.4 * random.normal());
    const double I = related ? 0.3 + elongation : 0.5 + 0.3 * random.uniform();
    population.blocks.push_back(make_measured_block(
        "b" + std::to_string(i), {I * (1.0 + elongation), I, 0.7 * I}, 1000.0 * I));
  }
  return population;
}

TEST(Summarised, HoldsEverySchemeAndMeasure) {
  const PopulationSummary summary = summarise_population(deposit("talus", 1, 40, 0.3));
  EXPECT_EQ(summary.blocks, 40u);
  EXPECT_EQ(summary.blocks_with_mass, 40u);
  ASSERT_EQ(summary.schemes.size(), scheme_names().size());
  for (const SchemeFractions& scheme : summary.schemes) {
    EXPECT_EQ(scheme.fractions.size(), class_names(scheme.scheme).size());
    std::size_t count = 0;
    double mass = 0.0;
    for (const ClassFraction& share : scheme.fractions) {
      count += share.count;
      mass += share.mass_fraction;
    }
    EXPECT_EQ(count, 40u);
    EXPECT_NEAR(mass, 1.0, 1e-12);
  }
  EXPECT_EQ(summary.size_shape_correlations.size(), 3u);
  EXPECT_EQ(
      summarise_population(deposit("talus", 1, 5, 0.3), {.schemes = {"zingg"}}).schemes.size(), 1u);
}

TEST(Summarised, SizeAndShapeGoTogetherOnlyWhereTheyDo) {
  const auto related = summarise_population(deposit("a", 1, 60, 0.3, true)).size_shape_correlations;
  const auto unrelated = summarise_population(deposit("b", 1, 60, 0.3)).size_shape_correlations;
  EXPECT_STREQ(related[0].measure->name, "s_c");
  EXPECT_NEAR(related[0].test->statistic, 1.0, 1e-12);
  EXPECT_LT(related[0].test->p_value, 1e-9);
  EXPECT_LT(std::abs(unrelated[0].test->statistic), 0.4);
}

TEST(Summarised, UnscaledBlocksHaveClassesAndNoSizes) {
  Population population = deposit("talus", 1, 40, 0.3);
  const PopulationSummary metric = summarise_population(population);
  MeasuredBlock model = make_measured_block("model", {70.0, 50.0, 40.0});
  model.unscaled = true;
  population.blocks.insert(population.blocks.begin() + 20, model);
  const PopulationSummary summary = summarise_population(population);
  EXPECT_EQ(summary.blocks, 41u);
  std::size_t counted = 0;
  for (const ClassFraction& share : summary.schemes.front().fractions) counted += share.count;
  EXPECT_EQ(counted, 41u);
  EXPECT_EQ(summary.size.by_number.blocks, 40u);
  EXPECT_EQ(summary.size.by_number.d90, metric.size.by_number.d90);
  EXPECT_EQ(summary.size.by_mass->d50, metric.size.by_mass->d50);
  EXPECT_EQ(summary.size.total_mass, metric.size.total_mass);
  EXPECT_EQ(summary.size_shape_correlations[0].test->statistic,
            metric.size_shape_correlations[0].test->statistic);

  const PopulationSummary alone = summarise_population({"models", {model, model}});
  EXPECT_EQ(alone.size.by_number.blocks, 0u);
  EXPECT_FALSE(alone.size.by_mass.has_value());
  EXPECT_EQ(alone.c40, 0.0);
}

TEST(Summarised, OneBlockAndOneSizeSayWhatCanBeSaid) {
  Population cubes{"cubes", {}};
  for (int i = 0; i < 4; ++i) cubes.blocks.push_back(make_measured_block("c", {1, 1, 1}));
  const PopulationSummary summary = summarise_population(cubes);
  EXPECT_FALSE(summary.size_shape_correlations[0].test);
  EXPECT_EQ(summary.size_shape_correlations[2].blocks, 0u);  // d of L = S is not defined
  EXPECT_TRUE(summary.size.by_number.laws.empty());
  EXPECT_EQ(summary.blocks_with_mass, 0u);
  EXPECT_EQ(summarise_population({"one", {make_measured_block("x", {3, 2, 1})}}).blocks, 1u);
  EXPECT_TRUE(contains(refusal([] { summarise_population({"none", {}}); }), "none"));
}

TEST(Compared, SaysThatDifferentDepositsDiffer) {
  const PopulationComparison comparison =
      compare_populations(deposit("P1", 1, 60, 0.2), deposit("P2", 2, 80, 0.5));
  const ShapeMeasureDifference& s_c = comparison.measures.at(0);
  EXPECT_LT(s_c.test->p_value, 1e-6);
  EXPECT_LT(s_c.median_a, s_c.median_b);
  for (const char* part : {"differ", "median", "P1 (60 blocks)", "P2 (80)", "less than 0.0001"}) {
    EXPECT_TRUE(contains(s_c.description, part));
  }
  const ClassFractionDifference& garcia = comparison.schemes.at(2);
  EXPECT_EQ(garcia.scheme, "garcia");
  EXPECT_LT(garcia.test->p_value, 1e-6);
  EXPECT_TRUE(contains(garcia.description, "compact") || contains(garcia.description, "elongated"));
}

TEST(Compared, SaysThatNothingIsShownWhereNothingIs) {
  const PopulationComparison comparison =
      compare_populations(deposit("P1", 1, 30, 0.3), deposit("P2", 3, 30, 0.3));
  EXPECT_TRUE(contains(comparison.measures.at(0).description, "No difference"));
  EXPECT_TRUE(contains(comparison.schemes.at(2).description, "can be shown"));
}

TEST(Compared, EqualPopulationsHaveNoDistance) {
  const Population one = deposit("P1", 1, 30, 0.3);
  const PopulationComparison comparison = compare_populations(one, one);
  for (const ShapeMeasureDifference& measure : comparison.measures) {
    EXPECT_EQ(measure.test->statistic, 0.0);
    EXPECT_EQ(measure.test->p_value, 1.0);
  }
}

TEST(Compared, SmallExpectedCountsAreSaid) {
  const PopulationComparison comparison =
      compare_populations(deposit("P1", 1, 4, 0.2), deposit("P2", 2, 5, 0.5));
  EXPECT_TRUE(contains(comparison.schemes.at(2).description, "random tables"));
}

TEST(Compared, PopulationsOfOneClassHaveNothingToCompare) {
  Population cubes{"cubes", {make_measured_block("c", {1, 1, 1})}};
  const PopulationComparison comparison = compare_populations(cubes, cubes);
  EXPECT_FALSE(comparison.schemes.at(0).test);
  EXPECT_TRUE(contains(comparison.schemes.at(0).description, "one sneed-folk class"));
  EXPECT_FALSE(comparison.measures.at(2).test);
  EXPECT_TRUE(contains(comparison.measures.at(2).description, "not defined"));
}

// Ratios of decimals that are equal on paper: 1.1/0.8 and 0.55/0.4.
TEST(ShapeMeasures, TiesOnPaperAreTies) {
  const auto values = measure_values(
      shape_measures()[0], std::vector<Axes>{{1.1, 0.8, 0.5}, {0.55, 0.4, 0.2}, {1.3, 1, 1}});
  EXPECT_EQ(values[0], values[1]);
  EXPECT_NEAR(values[2], 0.3, 1e-12);
}

}  // namespace
}  // namespace clast
