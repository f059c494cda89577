#include "study/compare/ensemble_effects.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/error.hpp"
#include "core/random.hpp"
#include "tests/study/hand_made_results.hpp"

namespace clast {
namespace {

/// Runs of one block on `members` draws: runout = 20 + 40 a - 10 b + scatter m, of friction a of
/// "blue" and rolling friction b of "scree", both in [0, 1]; the friction of "scree" is drawn too
/// and does nothing.
CampaignResults drawn_results(std::uint32_t members, double scatter = 0.0) {
  CampaignResults results = hand_made_results();
  results.runs.clear();
  results.crossings.clear();
  results.planned_runs = 2 * members;
  Random random(7);
  for (std::uint32_t member = 0; member < members; ++member) {
    const double a = random.uniform(0.0, 1.0), b = random.uniform(0.0, 1.0);
    results.ground_sets.push_back(
        {"", member, {{0.01, a, 0.35}, {0.01, random.uniform(0.2, 0.8), b}}});
    for (const std::uint32_t run : {2 * member, 2 * member + 1}) {
      const double x = 20.0 + 40.0 * a - 10.0 * b + scatter * random.uniform(-1.0, 1.0);
      results.runs.push_back(hand_made_run(run, 0, x, 0.0));
      results.runs.back().ground_set = member;
      if (x > 35.0) results.crossings.push_back(hand_made_crossing(run, 1, 1.0, 2.0));
    }
  }
  return results;
}

const ParameterEffect& effect_of(const std::vector<ParameterEffect>& effects,
                                 const std::string& outcome, const std::string& zone,
                                 const std::string& parameter) {
  for (const ParameterEffect& effect : effects) {
    if (effect.outcome == outcome && effect.zone == zone && effect.parameter == parameter) {
      return effect;
    }
  }
  throw InputError(outcome + ", " + zone + " " + parameter + " is not there");
}

TEST(FirstOrderIndex, IsTheShareOfAdditiveParts) {
  // Y = 2 U1 + U2 + U3 / 2: variances 4 : 1 : 1/4.
  std::vector<double> u1, u2, nothing, y;
  Random random(3);
  for (int i = 0; i < 2000; ++i) {
    u1.push_back(random.uniform(0.0, 1.0));
    u2.push_back(random.uniform(0.0, 1.0));
    nothing.push_back(random.uniform(0.0, 1.0));
    y.push_back(2.0 * u1.back() + u2.back() + 0.5 * random.uniform(0.0, 1.0));
  }
  EXPECT_NEAR(estimate_first_order_index(u1, y).value(), 4.0 / 5.25, 0.02);
  EXPECT_NEAR(estimate_first_order_index(u2, y).value(), 1.0 / 5.25, 0.04);
  EXPECT_NEAR(estimate_first_order_index(nothing, y).value(), 0.0, 0.015);
}

// Without the correction for chance five groups of eight would seem to explain a tenth.
TEST(FirstOrderIndex, OfAParameterWithoutInfluenceIsZeroOnAverage) {
  double sum = 0.0;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    std::vector<double> x, y;
    Random random(seed);
    for (int i = 0; i < 40; ++i) {
      x.push_back(random.uniform(0.0, 1.0));
      y.push_back(random.uniform(0.0, 1.0));
    }
    sum += estimate_first_order_index(x, y).value();
  }
  EXPECT_LT(sum / 200.0, 0.05);
}

TEST(FirstOrderIndex, SeesWhatRisesAndFallsAndRankCorrelationDoesNot) {
  std::vector<double> x, y;
  for (int i = 0; i < 400; ++i) {
    x.push_back(i);
    y.push_back(std::abs(i - 199.5));
  }
  EXPECT_GT(estimate_first_order_index(x, y).value(), 0.95);
  EXPECT_NEAR(spearman_test(x, y)->statistic, 0.0, 0.01);
}

TEST(FirstOrderIndex, NeedsFortyPairsThatDiffer) {
  const std::vector<double> few(39, 1.0), same(40, 1.0);
  std::vector<double> rising;
  for (int i = 0; i < 40; ++i) rising.push_back(i);
  EXPECT_FALSE(estimate_first_order_index(few, few));
  EXPECT_FALSE(estimate_first_order_index(same, rising));
  EXPECT_FALSE(estimate_first_order_index(rising, same));
  EXPECT_EQ(estimate_first_order_index(rising, rising).has_value(), true);
}

TEST(EnsembleEffects, NameTheParameterThatMovesTheOutcome) {
  const auto effects = compute_ensemble_effects(compared(drawn_results(80)));
  // 3 drawn parameters; the mean runout and the two barriers.
  ASSERT_EQ(effects.size(), 9u);
  const ParameterEffect& strong = effect_of(effects, "mean runout", "blue", "friction");
  EXPECT_EQ(strong.members, 80u);
  EXPECT_GT(strong.correlation->statistic, 0.9);
  EXPECT_GT(strong.first_order.value(), 0.85);
  const ParameterEffect& weak = effect_of(effects, "mean runout", "scree", "rolling_friction");
  EXPECT_LT(weak.correlation->statistic, 0.0);
  EXPECT_LT(weak.first_order.value(), 0.25);
  const ParameterEffect& none = effect_of(effects, "mean runout", "scree", "friction");
  EXPECT_GT(none.correlation->p_value, 0.05);
  EXPECT_GT(strong.outcome_p95, strong.outcome_median);
  EXPECT_LT(strong.outcome_p5, 30.0);
  EXPECT_GT(effect_of(effects, "past B2", "blue", "friction").correlation->statistic, 0.7);
  EXPECT_FALSE(effect_of(effects, "past B<1>", "blue", "friction").correlation) << "none crosses";
}

TEST(EnsembleEffects, OfFewMembersHaveNoIndex) {
  const auto effects = compute_ensemble_effects(compared(drawn_results(5)));
  ASSERT_EQ(effects.size(), 9u);
  EXPECT_TRUE(effects.front().correlation);
  EXPECT_FALSE(effects.front().first_order);
}

TEST(EnsembleEffects, AreNoneWithoutAnEnsemble) {
  EXPECT_TRUE(compute_ensemble_effects(compared(hand_made_results())).empty());
  EXPECT_TRUE(compute_ensemble_effects(compared(drawn_results(1))).empty());
  EXPECT_EQ(count_ensemble_members(hand_made_results()), 1u);
}

TEST(EnsembleEffects, AreOfTheRunsOfEachBlockGroup) {
  CampaignResults results = drawn_results(6);
  const std::vector<GroundParameterSet> sets = results.ground_sets;
  for (GroundParameterSet set : sets) {
    set.group = "schist";
    set.zones[0].friction = 0.5;  // of this group it is not drawn
    results.ground_sets.push_back(set);
  }
  for (std::uint32_t i = 0; i < 12; i += 2) results.runs[i].ground_set += 6;
  std::size_t of_group = 0;
  for (const ParameterEffect& effect : compute_ensemble_effects(compared(std::move(results)))) {
    if (effect.group != "schist") continue;
    ++of_group;
    EXPECT_NE(effect.zone, "blue");
  }
  EXPECT_EQ(of_group, 6u);
}

}  // namespace
}  // namespace clast
