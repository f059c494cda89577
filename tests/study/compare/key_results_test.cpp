// What a comparison says: what is there, with its interval, and nothing that the data do not carry.
#include "study/compare/key_results.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "tests/study/made_up_runs.hpp"

namespace clast {
namespace {

const FileSummary& only(const KeyResults& answer) { return answer.file_summaries.at(0); }

TEST(KeyResults, ADifferenceThatIsThereIsToldWithItsInterval) {
  int inside = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const Comparison comparison = compared(made_up_results({.seed = seed}));
    const KeyResults found = summarise_key_results(comparison);
    const RunoutContrast& gap = only(found).class_contrast.value();
    EXPECT_EQ(comparison.groups[gap.farther].key, "compact");
    EXPECT_EQ(gap.verdict, ContrastVerdict::kSignificant) << seed;
    ASSERT_TRUE(gap.interval);
    inside += gap.interval->low <= 10.0 && 10.0 <= gap.interval->high ? 1 : 0;
    EXPECT_EQ(only(found).clusters, 8u);
  }
  EXPECT_GE(inside, 15) << "of 20; eight points give intervals that are a little too narrow";
}

TEST(KeyResults, TheFartherClassIsNamedFirstAndItsGapIsPositive) {
  const Comparison comparison = compared(made_up_results({.compact = 30.0, .elongated = 40.0}));
  const RunoutContrast gap = *only(summarise_key_results(comparison)).class_contrast;
  EXPECT_EQ(comparison.groups[gap.farther].key, "elongated");
  EXPECT_GT(gap.mean_difference, 0.0);
  EXPECT_GT(gap.interval->low, 0.0);
  EXPECT_LT(gap.interval->low, gap.mean_difference);
  EXPECT_GT(gap.interval->high, gap.mean_difference);
}

TEST(KeyResults, WhatIsNotThereIsSeldomTold) {
  int found = 0;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const Comparison comparison =
        compared(made_up_results({.compact = 30.0, .elongated = 30.0, .seed = seed}));
    const RunoutContrast gap = *only(summarise_key_results(comparison)).class_contrast;
    found += gap.verdict == ContrastVerdict::kSignificant ? 1 : 0;
  }
  EXPECT_LE(found, 5) << "of 40";
}

TEST(KeyResults, AnotherSpreadAroundTheSameMeanIsNoOtherRunout) {
  CampaignResults results = made_up_results({.compact = 30.0, .elongated = 30.0, .runs_each = 40});
  // Elongated blocks stop at either of two places, as far above as below.
  int i = 0;
  for (RunRecord& run : results.runs) {
    if (run.block == 1) run.result.final_state.position.x() += i++ % 2 == 0 ? 12.0 : -12.0;
  }
  const Comparison comparison = compared(std::move(results));
  EXPECT_EQ(only(summarise_key_results(comparison)).class_contrast->verdict,
            ContrastVerdict::kDistributionDiffers);
}

TEST(KeyResults, RunsThatLeaveTheTerrainLeaveNothingToCompare) {
  CampaignResults results = made_up_results();
  for (RunRecord& run : results.runs) {
    if (run.block == 0 && run.run % 3 != 0) run.result.stop_reason = StopReason::kLeftTerrain;
  }
  const Comparison comparison = compared(std::move(results));
  const FileSummary statement = only(summarise_key_results(comparison));
  EXPECT_EQ(statement.class_contrast->verdict, ContrastVerdict::kTooFewValues)
      << "a third of the compact runs is left";
  EXPECT_FALSE(statement.class_contrast->interval);
  EXPECT_GT(statement.stops.left_terrain, 0u);
}

TEST(KeyResults, OneRealisationTellsNothingOfChance) {
  CampaignResults results = made_up_results();
  let_stay(results, 1);
  const Comparison comparison = compared(std::move(results));
  const FileSummary statement = only(summarise_key_results(comparison));
  EXPECT_EQ(statement.class_contrast->verdict, ContrastVerdict::kUntested);
  EXPECT_FALSE(statement.class_contrast->interval);
  EXPECT_FALSE(statement.all.interval);
  EXPECT_TRUE(statement.clusters_are_realisations);
}

TEST(KeyResults, TheLastBarrierThatIsPassedComesFirst) {
  CampaignResults results = made_up_results();
  add_barrier(results, "upper", 10.0);
  add_barrier(results, "lower", 38.0);
  add_barrier(results, "never", 500.0);
  const Comparison comparison = compared(std::move(results));
  const std::vector<BarrierSummary> passages = only(summarise_key_results(comparison)).passages;
  ASSERT_EQ(passages.size(), 3u);
  EXPECT_EQ(comparison.lines[passages[0].line].name, "lower");
  EXPECT_EQ(comparison.lines[passages[1].line].name, "upper");
  EXPECT_EQ(comparison.lines[passages[2].line].name, "never");
  EXPECT_EQ(passages[2].all.crossed, 0u);
  EXPECT_EQ(passages[2].all.passing_probability, 0.0);
  EXPECT_GT(passages[2].all.interval->high, 0.0) << "none of 192 is not never";

  // By counting: the share of each class, and 95 % of the passages below.
  ASSERT_EQ(passages[0].classes.size(), 2u);
  std::vector<double> energies;
  std::size_t compact = 0, runs = 0;
  for (const RunRecord& run : comparison.results[0].runs) {
    const double beyond = run.result.final_state.position.x() - 38.0;
    runs += run.block == 0;
    if (beyond > 0.0) energies.push_back(1000.0 * beyond);
    compact += run.block == 0 && beyond > 0.0;
  }
  EXPECT_NEAR(passages[0].classes[0].passing_probability,
              static_cast<double>(compact) / static_cast<double>(runs), 1e-12);
  std::sort(energies.begin(), energies.end());
  ASSERT_GE(energies.size(), kMinPassages);
  EXPECT_FALSE(passages[0].all.largest);
  EXPECT_NEAR(passages[0].all.energy, quantile(energies, 0.95), 1e-9);
  EXPECT_NEAR(passages[0].all.height, 1e-5 * quantile(energies, 0.95), 1e-12);
}

TEST(KeyResults, OfFewPassagesTheLargestIsSaid) {
  CampaignResults results = made_up_results({.points = 1, .runs_each = 12});
  add_barrier(results, "B", 40.0);
  const Comparison comparison = compared(std::move(results));
  const BarrierSummary passage = only(summarise_key_results(comparison)).passages.at(0);
  ASSERT_GT(passage.all.crossed, 0u);
  ASSERT_LT(passage.all.crossed, kMinPassages);
  EXPECT_TRUE(passage.all.largest);
  double maximum = 0.0;
  for (const Crossing& crossing : comparison.results[0].crossings) {
    maximum = std::max(maximum, crossing.translational_energy);
  }
  EXPECT_EQ(passage.all.energy, maximum);
}

TEST(KeyResults, SharesOfRunsThatDependOnTheirPointHaveWiderIntervals) {
  // From half of the points every run passes, from the others none.
  CampaignResults results = made_up_results({.scatter = 0.01, .places = 20.0, .runs_each = 40});
  add_barrier(results, "B", 40.0);
  const Comparison comparison = compared(std::move(results));
  const CrossingEstimate all = only(summarise_key_results(comparison)).passages.at(0).all;
  const Interval runs = wilson_interval(all.crossed, all.started);
  EXPECT_GT(all.interval->high - all.interval->low, 3.0 * (runs.high - runs.low));
}

TEST(KeyResults, FilesOfOneClassEachAreComparedAsOneStudy) {
  const Comparison comparison =
      compared(made_up_results({.elongated = NAN}), made_up_results({.compact = NAN, .seed = 2}));
  const KeyResults found = summarise_key_results(comparison);
  ASSERT_EQ(found.file_summaries.size(), 1u);
  EXPECT_FALSE(found.files);
  EXPECT_EQ(only(found).class_contrast->verdict, ContrastVerdict::kSignificant);
  EXPECT_EQ(comparison.groups[only(found).class_contrast->farther].key, "compact");
}

// Pooled, the elongated blocks would seem to run farther, since most of them run on the long slope.
TEST(KeyResults, SitesAreNotMixed) {
  CampaignResults near = made_up_results({.compact = 30.0, .elongated = 20.0, .runs_each = 12});
  std::erase_if(near.runs, [](const RunRecord& run) { return run.block == 1 && run.run % 4 != 0; });
  CampaignResults far = made_up_results({.compact = 90.0, .elongated = 80.0, .seed = 2});
  std::erase_if(far.runs, [](const RunRecord& run) { return run.block == 0 && run.run % 4 != 0; });
  const Comparison comparison = compared(std::move(near), std::move(far));
  const KeyResults found = summarise_key_results(comparison);
  ASSERT_EQ(found.file_summaries.size(), 2u);
  for (const FileSummary& statement : found.file_summaries) {
    EXPECT_EQ(comparison.groups[statement.class_contrast->farther].key, "compact");
    EXPECT_EQ(statement.class_contrast->verdict, ContrastVerdict::kSignificant);
    EXPECT_NEAR(statement.class_contrast->mean_difference, 10.0, 3.0);
  }
  // The same release points: how far the two differ can be said.
  ASSERT_TRUE(found.files);
  EXPECT_EQ(comparison.groups[found.files->farther].file, 1u);
  EXPECT_EQ(found.files->verdict, ContrastVerdict::kSignificant);
}

/// Mean runouts of the runs of a draw that are of a block, by counting.
double mean_of_draw(const CampaignResults& results, std::uint32_t draw,
                    std::optional<std::uint32_t> block) {
  double sum = 0.0, count = 0.0;
  for (const RunRecord& run : results.runs) {
    if (run.ground_set != draw || (block && run.block != *block)) continue;
    sum += run.result.final_state.position.x();
    ++count;
  }
  return sum / count;
}

TEST(KeyResults, UncertainGroundGivesRangesOverItsDraws) {
  CampaignResults results = made_up_results({.runs_each = 20});
  draw_ground(results, 5, 4.0);
  add_barrier(results, "road", 35.0);
  const Comparison comparison = compared(std::move(results));
  const CampaignResults& stored = comparison.results[0];
  const FileSummary statement = only(summarise_key_results(comparison));
  EXPECT_EQ(statement.draws, 5u);
  std::vector<double> means, gaps, shares, energies;
  for (std::uint32_t draw = 0; draw < 5; ++draw) {
    means.push_back(mean_of_draw(stored, draw, std::nullopt));
    gaps.push_back(mean_of_draw(stored, draw, 0) - mean_of_draw(stored, draw, 1));
    std::vector<double> of_draw;
    double runs = 0.0;
    for (const RunRecord& run : stored.runs) {
      if (run.ground_set != draw) continue;
      ++runs;
      const double beyond = run.result.final_state.position.x() - 35.0;
      if (beyond > 0.0) of_draw.push_back(1000.0 * beyond);
    }
    shares.push_back(static_cast<double>(of_draw.size()) / runs);
    std::sort(of_draw.begin(), of_draw.end());
    energies.push_back(quantile(of_draw, 0.95));
  }
  const auto expect_range = [](const std::optional<Interval>& found, std::vector<double> values) {
    ASSERT_TRUE(found);
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    EXPECT_NEAR(found->low, *low, 1e-9);
    EXPECT_NEAR(found->high, *high, 1e-9);
  };
  expect_range(statement.all.interval, means);
  expect_range(statement.class_contrast->interval, gaps);
  expect_range(statement.passages[0].all.interval, shares);
  expect_range(statement.passages[0].all.energy_range, energies);
  EXPECT_TRUE(statement.passages[0].all.speed_range);
  EXPECT_TRUE(statement.passages[0].all.top_range);
  // The pooled limit says nothing of that.
  EXPECT_GT(statement.passages[0].all.energy_range->high, statement.passages[0].all.energy);
}

TEST(KeyResults, ManyDrawsGiveTheRangeOfNineOfTen) {
  CampaignResults results = made_up_results({.runs_each = 20});
  draw_ground(results, 20, 1.0);
  const Comparison comparison = compared(std::move(results));
  const std::optional<Interval> range = only(summarise_key_results(comparison)).all.interval;
  ASSERT_TRUE(range);
  EXPECT_NEAR(range->high - range->low, 17.1, 4.0) << "19 m from first to last draw";
}

TEST(KeyResults, WhichRunsFartherCanDependOnTheDraw) {
  CampaignResults results = made_up_results({.compact = 40.0, .elongated = 34.0, .runs_each = 20});
  draw_ground(results, 4, 0.0);
  // In the last draw elongated blocks run on.
  for (RunRecord& run : results.runs) {
    if (run.block == 1 && run.ground_set == 3) run.result.final_state.position.x() += 15.0;
  }
  const Comparison comparison = compared(std::move(results));
  const RunoutContrast gap = *only(summarise_key_results(comparison)).class_contrast;
  EXPECT_EQ(gap.verdict, ContrastVerdict::kGroundDependent);
  EXPECT_LT(gap.interval->low, 0.0);
  EXPECT_GT(gap.interval->high, 0.0);
}

TEST(KeyResults, OneDrawIsNoRange) {
  const Comparison comparison = compared(made_up_results());
  const FileSummary statement = only(summarise_key_results(comparison));
  EXPECT_EQ(statement.draws, 0u);
  EXPECT_FALSE(summarise_key_results(comparison).has_draws());
}

TEST(KeyResults, IntervalsOfTheSameBlocksEverywhereSpeakOfThemAlone) {
  const Comparison same = compared(made_up_results());
  EXPECT_EQ(only(summarise_key_results(same)).blocks, 2u);
  EXPECT_FALSE(only(summarise_key_results(same)).samples_blocks);
  // Each realisation draws its blocks out of many.
  CampaignResults drawn = made_up_results({.runs_each = 12});
  let_stay(drawn, 8);
  for (std::uint32_t block = 2; block < 32; ++block) {
    drawn.blocks.push_back(drawn.blocks[block % 2]);
    drawn.blocks.back().id = "drawn" + std::to_string(block);
  }
  for (RunRecord& run : drawn.runs) {
    const std::uint32_t realisation = run.run / drawn.persistent_blocks->blocks_per_realisation;
    run.block += 2 * (2 * realisation + run.run % 2);
  }
  const Comparison sampled = compared(std::move(drawn));
  EXPECT_TRUE(only(summarise_key_results(sampled)).samples_blocks);
  EXPECT_GT(only(summarise_key_results(sampled)).blocks, 20u);
}

}  // namespace
}  // namespace clast
