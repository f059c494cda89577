// What the variance of outcomes is due to, of campaigns that run every combination.
#include "study/compare/design_effects.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/study/hand_made_results.hpp"
#include "tests/support/refusal.hpp"

namespace clast {
namespace {

/// Every combination of two blocks, three orientations and two points: the runout is
/// 20 + 3 b + 4 o + 10 p m with b and p in {-1, 1} and o in {-1, 0, 1}.
CampaignResults factorial_results() {
  CampaignResults results = hand_made_results();
  results.runs.clear();
  results.crossings.clear();
  results.planned_runs = 12;
  results.release_points.push_back(results.release_points[0]);
  std::uint32_t run = 0;
  for (std::uint32_t block = 0; block < 2; ++block) {
    for (std::uint32_t point = 0; point < 2; ++point) {
      for (std::uint32_t orientation = 0; orientation < 3; ++orientation, ++run) {
        const double x = 20.0 + 3.0 * (2.0 * block - 1.0) + 4.0 * (orientation - 1.0) +
                         10.0 * (2.0 * point - 1.0);
        results.runs.push_back(hand_made_run(run, block, x, 0.0));
        results.runs.back().point = point;
        results.runs.back().orientation = orientation;
        results.runs.back().start.orientation =
            Quat(Eigen::AngleAxisd(0.5 * orientation, Vec3::UnitZ()));
        if (point == 1) results.crossings.push_back(hand_made_crossing(run, 0, 1.0, 2.0));
      }
    }
  }
  return results;
}

DesignEffects effects_of(CampaignResults results) {
  return compute_design_effects(compared(std::move(results))).at(0);
}

TEST(DesignEffects, AreTheSharesOfWhatTheRunoutIsMadeOf) {
  const DesignEffects effects = effects_of(factorial_results());
  ASSERT_EQ(effects.refusal_reason, "");
  ASSERT_EQ(effects.factors.size(), 3u);
  EXPECT_EQ(effects.factors[0].name, "block") << "form and mass differ together";
  EXPECT_EQ(effects.factors[1].name, "orientation");
  EXPECT_EQ(effects.factors[2].name, "release point");
  EXPECT_EQ(effects.factors[1].levels, 3u);
  const OutcomeEffects& runout = effects.outcomes.at(0);
  EXPECT_EQ(runout.outcome, "runout");
  EXPECT_NEAR(runout.mean, 20.0, 1e-9);
  const double total = 9.0 + 16.0 * 2.0 / 3.0 + 100.0;
  EXPECT_NEAR(runout.shares.factors[0].design_fraction, 9.0 / total, 1e-9);
  EXPECT_NEAR(runout.shares.factors[1].design_fraction, 16.0 * 2.0 / 3.0 / total, 1e-9);
  EXPECT_NEAR(runout.shares.factors[2].design_fraction, 100.0 / total, 1e-9);
  // Who passes is decided by the point alone; nobody passes B2; nobody leaves the line.
  const OutcomeEffects& passing = effects.outcomes.back();
  EXPECT_EQ(passing.outcome, "passing B<1>");
  EXPECT_NEAR(passing.mean, 0.5, 1e-12);
  EXPECT_NEAR(passing.shares.factors[2].design_fraction, 1.0, 1e-12);
  for (const OutcomeEffects& outcome : effects.outcomes) EXPECT_NE(outcome.outcome, "passing B2");
}

TEST(DesignEffects, BlocksOfOneMassAreForms) {
  CampaignResults results = factorial_results();
  results.blocks[1].mass = 1.002 * results.blocks[0].mass;
  EXPECT_EQ(effects_of(std::move(results)).factors[0].name, "form");
}

TEST(DesignEffects, FormAndMassAreTwoFactorsWhereEachBlockHasEachMass) {
  CampaignResults results = factorial_results();
  const std::vector<BlockSummary> kinds = results.blocks;
  results.blocks.clear();
  for (const BlockSummary& kind : kinds) {
    for (const double mass : {100.0, 200.0}) {
      results.blocks.push_back(kind);
      results.blocks.back().id = kind.id + " " + std::to_string(mass);
      results.blocks.back().library_id = kind.id;
      results.blocks.back().mass = mass;
    }
  }
  const std::vector<RunRecord> runs = results.runs;
  results.runs.clear();
  results.crossings.clear();
  for (std::uint32_t i = 0; i < 24; ++i) {
    results.runs.push_back(runs[i / 2]);
    results.runs.back().run = i;
    results.runs.back().block = 2 * runs[i / 2].block + i % 2;
  }
  results.planned_runs = 24;
  const DesignEffects effects = effects_of(std::move(results));
  ASSERT_EQ(effects.factors.size(), 4u) << effects.refusal_reason;
  EXPECT_EQ(effects.factors[0].name, "form");
  EXPECT_EQ(effects.factors[1].name, "mass");
  EXPECT_NEAR(effects.outcomes.at(0).shares.factors[1].design_fraction, 0.0, 1e-12);
}

TEST(DesignEffects, OfWhatIsNoFullDesignAreEstimates) {
  CampaignResults missing = factorial_results();
  missing.runs.pop_back();
  missing.crossings.clear();
  const DesignEffects effects = effects_of(std::move(missing));
  EXPECT_EQ(effects.refusal_reason, "");
  EXPECT_TRUE(contains(effects.estimated, "11 runs do not contain every combination exactly once"));
  EXPECT_TRUE(contains(effects.estimated, "block 2, orientation 3, release point 2: 12"));
  const VarianceDecomposition& runout = effects.outcomes.at(0).shares;
  EXPECT_TRUE(std::isnan(runout.factors[2].design_fraction));
  // The points: 200 of 9 x 2 + 16 + 200, of the population.
  EXPECT_NEAR(runout.factors[2].estimate, 200.0 / 234.0, 0.05);
  CampaignResults twice = factorial_results();
  twice.runs[3].orientation = twice.runs[4].orientation;
  twice.runs[3].start.orientation = twice.runs[4].start.orientation;
  EXPECT_TRUE(contains(effects_of(std::move(twice)).estimated,
                       "do not contain every combination exactly once"));
}

TEST(DesignEffects, OfOrientationsDrawnAnewHaveNoFactorOfThem) {
  CampaignResults fresh = factorial_results();
  fresh.runs[4].start.orientation = Quat(Eigen::AngleAxisd(1.7, Vec3::UnitX()));
  const DesignEffects effects = effects_of(std::move(fresh));
  EXPECT_TRUE(contains(effects.estimated, "drawn for each block"));
  ASSERT_EQ(effects.factors.size(), 2u);
  EXPECT_EQ(effects.factors[1].name, "release point");
}

TEST(DesignEffects, OfWhatHasNoEffectsAreRefusedWithTheReason) {
  CampaignResults staying = factorial_results();
  staying.persistent_blocks.emplace();
  staying.persistent_blocks->blocks_per_realisation = 12;
  EXPECT_TRUE(contains(effects_of(std::move(staying)).refusal_reason, "depend on each other"));
  CampaignResults one = factorial_results();
  one.runs.resize(1);
  one.crossings.clear();
  EXPECT_TRUE(
      contains(effects_of(std::move(one)).refusal_reason, "its runs do not differ in anything"));
}

}  // namespace
}  // namespace clast
