// Shares of the variance where combinations are missing.
#include "core/statistics/unbalanced_variance.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "core/random.hpp"
#include "tests/support/refusal.hpp"

namespace clast {
namespace {

using Levels = std::vector<std::uint32_t>;

/// A study of form, orientation and release point, of which some runs are missing.
struct UnbalancedStudy {
  std::vector<double> deviations;  ///< of the three, the interaction of the first two, the rest
  std::function<double(Random&)> draw;  ///< mean 0, deviation 1
  double missing = 0.3;
  bool fresh = false;  ///< orientations are met once each and are no factor

  std::vector<double> truth() const {
    double total = 0.0;
    for (const double s : deviations) total += s * s;
    std::vector<double> shares = {deviations[0] * deviations[0] / total};
    if (!fresh) shares.push_back(deviations[1] * deviations[1] / total);
    shares.push_back(deviations[2] * deviations[2] / total);
    return shares;
  }
};

struct Drawn {
  std::vector<double> values;
  std::vector<Levels> factors;
};

Drawn drawn_from(const UnbalancedStudy& study, const std::vector<std::uint32_t>& levels,
                 Random& random) {
  std::vector<std::vector<double>> alone(3);
  for (std::size_t f = 0; f < 3; ++f) {
    for (std::uint32_t i = 0; i < levels[f]; ++i) {
      alone[f].push_back(study.deviations[f] * study.draw(random));
    }
  }
  Levels forms, turns, points;
  std::vector<double> values;
  for (std::uint32_t i = 0; i < levels[0]; ++i) {
    for (std::uint32_t j = 0; j < levels[1]; ++j) {
      const double pair = study.deviations[3] * study.draw(random);
      for (std::uint32_t k = 0; k < levels[2]; ++k) {
        const double turn = study.fresh ? study.deviations[1] * study.draw(random) : alone[1][j];
        const double value =
            alone[0][i] + turn + alone[2][k] + pair + study.deviations[4] * study.draw(random);
        if (random.uniform() < study.missing) continue;
        values.push_back(value);
        forms.push_back(i);
        turns.push_back(j);
        points.push_back(k);
      }
    }
  }
  if (study.fresh) return {values, {forms, points}};
  return {values, {forms, turns, points}};
}

/// Of so many studies, the smallest share over the factors of intervals that hold the truth.
double unbalanced_coverage(const UnbalancedStudy& study, const std::vector<std::uint32_t>& levels,
                           int studies) {
  Random random(11);
  std::vector<int> held(study.truth().size(), 0);
  for (int i = 0; i < studies; ++i) {
    const Drawn drawn = drawn_from(study, levels, random);
    const std::vector<std::vector<double>> outcomes = {drawn.values};
    const VarianceDecomposition shares =
        decompose_unbalanced_variance(outcomes, drawn.factors).front();
    for (std::size_t f = 0; f < held.size(); ++f) {
      const Interval& interval = shares.factors[f].interval;
      const double truth = study.truth()[f];
      if (interval.low <= truth && truth <= interval.high) ++held[f];
    }
  }
  return *std::min_element(held.begin(), held.end()) / static_cast<double>(studies);
}

double normal(Random& random) { return random.normal(); }
double skewed(Random& random) { return -std::log(1.0 - random.uniform()) - 1.0; }

// With every combination once the equations are those of the analysis of variance.
TEST(UnbalancedShares, OfAFullDesignAreThoseOfTheDesign) {
  Random random(3);
  const Drawn drawn = drawn_from({{2.0, 1.5, 2.0, 1.0, 0.7}, normal, 0.0}, {8, 7, 6}, random);
  const std::vector<std::vector<double>> outcomes = {drawn.values};
  const VarianceDecomposition found =
      decompose_unbalanced_variance(outcomes, drawn.factors).front();
  const std::vector<std::size_t> levels = {8, 7, 6};
  const VarianceDecomposition design = decompose_variance(drawn.values, levels);
  for (std::size_t f = 0; f < 3; ++f) {
    EXPECT_NEAR(found.factors[f].estimate, design.factors[f].estimate, 0.02);
    EXPECT_TRUE(std::isnan(found.factors[f].design_fraction));
  }
  EXPECT_NEAR(found.variance, design.variance, 0.02 * design.variance);
}

TEST(UnbalancedShares, OfALargeStudyAreTheTruth) {
  Random random(5);
  const UnbalancedStudy study{{1.0, 0.5, 1.0, 0.7, 1.0}, normal};
  const Drawn drawn = drawn_from(study, {40, 40, 30}, random);
  const std::vector<std::vector<double>> outcomes = {drawn.values};
  const VarianceDecomposition found =
      decompose_unbalanced_variance(outcomes, drawn.factors).front();
  for (std::size_t f = 0; f < 3; ++f) {
    EXPECT_NEAR(found.factors[f].estimate, study.truth()[f], 0.1);
  }
}

// Of intervals of 95 %; 60 studies know that share to 0.03. Figures of 200 are in docs/theory.md.
TEST(UnbalancedShares, IntervalsCover) {
  EXPECT_GE(unbalanced_coverage({{1.0, 1.0, 1.0, 0.7, 1.0}, normal}, {12, 12, 6}, 60), 0.88);
  EXPECT_GE(unbalanced_coverage({{1.0, 1.0, 1.0, 0.7, 1.0}, normal, 0.2, true}, {12, 8, 6}, 60),
            0.88);
  EXPECT_GE(unbalanced_coverage({{1.0, 1.0, 0.7, 0.7, 1.0}, skewed}, {12, 12, 6}, 60), 0.86);
}

TEST(UnbalancedShares, RefuseWhatHasNoShares) {
  const std::vector<std::vector<double>> outcomes = {{1.0, 2.0, 3.0}};
  const std::vector<Levels> one = {{4, 4, 4}}, none;
  EXPECT_TRUE(
      contains(refusal([&] { decompose_unbalanced_variance(outcomes, one); }), "one level"));
  EXPECT_TRUE(
      contains(refusal([&] { decompose_unbalanced_variance(outcomes, none); }), "one to six"));
  const std::vector<Levels> longer = {{1, 2, 3, 4}};
  EXPECT_TRUE(
      contains(refusal([&] { decompose_unbalanced_variance(outcomes, longer); }), "3 values"));
  const std::vector<Levels> two = {{0, 0, 1}};
  const std::vector<std::vector<double>> same = {{2.0, 2.0, 2.0}};
  EXPECT_EQ(decompose_unbalanced_variance(same, two).front().variance, 0.0);
}

}  // namespace
}  // namespace clast
