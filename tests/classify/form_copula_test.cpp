// Grids of forms, and forms drawn from a population.
#include "classify/form_copula.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "classify/form_grid.hpp"
#include "classify/schemes.hpp"
#include "core/error.hpp"
#include "core/statistics/sample_tests.hpp"
#include "tests/support/refusal.hpp"

namespace clast {
namespace {

TEST(FormGrid, CoversTheTriangleOfSneedAndFolkInEqualSteps) {
  const std::vector<Axes> forms = sneed_folk_grid(10, 0.2);
  ASSERT_EQ(forms.size(), 66u);
  std::set<std::string> classes;
  for (const Axes& axes : forms) {
    EXPECT_EQ(axes.L, 1.0);
    EXPECT_TRUE(axes.L >= axes.I && axes.I >= axes.S && axes.S >= 0.2 - 1e-12);
    classes.insert(sneed_folk_class(axes));
    // Steps of 0.08 in I/L as in S/L: a regular lattice.
    EXPECT_NEAR(std::remainder((1.0 - axes.I) / 0.08, 1.0), 0.0, 1e-9);
  }
  EXPECT_EQ(classes.size(), 10u) << "all classes";
  EXPECT_EQ(sneed_folk_class(forms.front()), "C");
  EXPECT_EQ(sneed_folk_class(forms[55]), "VP");
  EXPECT_EQ(sneed_folk_class(forms[60]), "VB");
  EXPECT_EQ(sneed_folk_class(forms[65]), "VE");
}

TEST(FormGrid, CoversZinggsDiagramAndRefusesNoGrid) {
  const std::vector<Axes> forms = zingg_grid(4, 0.3);
  ASSERT_EQ(forms.size(), 25u);
  EXPECT_EQ(zingg_class(forms[0]), "blade");
  EXPECT_EQ(zingg_class(forms[4]), "rod");
  EXPECT_EQ(zingg_class(forms[20]), "disc");
  EXPECT_EQ(zingg_class(forms[24]), "spheroid");
  EXPECT_TRUE(contains(refusal([] { sneed_folk_grid(0); }), "0 steps"));
  EXPECT_TRUE(contains(refusal([] { zingg_grid(3, NAN); }), "`least` = nan"));
}

/// Flatter the longer they are, all else by chance.
std::vector<BlockForm> drawn_population(std::size_t count) {
  Random random(5);
  std::vector<BlockForm> blocks;
  for (std::size_t i = 0; i < count; ++i) {
    const double size = random.normal();
    const double L = std::exp(0.4 * size), I = L * random.uniform(0.5, 1.0);
    const double flat = std::clamp(0.6 - 0.15 * size + 0.05 * random.normal(), 0.05, 1.0);
    blocks.push_back({{L, I, flat * I}, std::nullopt});
  }
  return blocks;
}

TEST(FormCopula, DrawsBlocksLikeThePopulation) {
  const std::vector<BlockForm> from = drawn_population(200);
  const FormCopula copula(from);
  Random random(1);
  std::vector<BlockForm> drawn;
  for (int i = 0; i < 3000; ++i) drawn.push_back(copula.sample(random));
  double longest = 0.0;
  for (const BlockForm& block : from) longest = std::max(longest, block.axes.L);
  for (const BlockForm& block : drawn) {
    EXPECT_TRUE(block.axes.L >= block.axes.I && block.axes.I >= block.axes.S);
    EXPECT_GT(block.axes.S, 0.0);
    EXPECT_LE(block.axes.L, longest * (1.0 + 1e-12));
    EXPECT_FALSE(block.convexity);
  }
  const CopulaFit fit = copula.assess_fit(drawn);
  EXPECT_LT(fit.max_cdf_difference, 0.04);
  EXPECT_EQ(fit.removed_correlation, 0.0);
  ASSERT_EQ(fit.correlations.size(), 3u);
  for (const RankCorrelation& pair : fit.correlations) {
    EXPECT_NEAR(pair.sampled, pair.population, 0.06) << pair.first << pair.second;
  }
  EXPECT_LT(fit.correlations[1].population, -0.8);
}

TEST(FormCopula, KeepsWhatIsTheSameOfAllBlocksAndRefusesTooFew) {
  std::vector<BlockForm> same(12, {{1.0, 0.8, 0.4}, 0.95});
  const FormCopula copula(same);
  Random random(2);
  const BlockForm block = copula.sample(random);
  EXPECT_NEAR(block.axes.S, 0.4, 1e-12);
  EXPECT_NEAR(block.convexity.value(), 0.95, 1e-12);
  EXPECT_TRUE(contains(refusal([&] { FormCopula{{same.data(), 9}}; }), "but there are 9"));
  same[3].axes.S = NAN;
  EXPECT_TRUE(contains(refusal([&] { FormCopula{same}; }), "nan"));
}

}  // namespace
}  // namespace clast
