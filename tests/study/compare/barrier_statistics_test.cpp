// What passes a barrier together, against crossings written by hand.
#include "study/compare/barrier_statistics.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/study/hand_made_results.hpp"

namespace clast {
namespace {

double one(const BlockCrossing&) { return 1.0; }

std::vector<BlockCrossing> passages_at(const std::vector<double>& times) {
  std::vector<BlockCrossing> passages;
  for (const double time : times) passages.push_back({.time = time, .energy = 10.0 * time});
  return passages;
}

TEST(LargestWithin, IsTheFullestWindowWhereverItBegins) {
  const std::vector<BlockCrossing> passages = passages_at({0.0, 0.9, 1.1, 1.5, 1.9, 2.2, 7.0});
  const WindowMaximum maximum = find_window_maximum(passages, 1.0, one);
  EXPECT_EQ(maximum.value, 4.0);  // from 0.9 to 1.9, both ends included
  EXPECT_EQ(maximum.from, 0.9);
  const WindowMaximum energy = find_window_maximum(
      passages, 1.0, [](const BlockCrossing& passage) { return passage.energy; });
  EXPECT_EQ(energy.value, 70.0);  // one block alone, more than the four
  EXPECT_EQ(energy.from, 7.0);
  EXPECT_EQ(find_window_maximum(passages, 10.0, one).value, 7.0);
  EXPECT_EQ(find_window_maximum(passages, 0.0, one).value, 1.0);
}

TEST(LargestWithin, OfNothingIsNone) {
  const WindowMaximum none = find_window_maximum({}, 1.0, one);
  EXPECT_EQ(none.value, 0.0);
  EXPECT_TRUE(std::isnan(none.from));
}

/// Two realisations of three blocks.
CampaignResults results_that_stay(bool at_once) {
  CampaignResults results = hand_made_results();
  results.persistent_blocks = {3, {0.01, 0.5, 0.3}, at_once};
  for (std::uint32_t run = 0; run < 6; ++run) {
    results.persistent_block_records.push_back(
        {.run = run, .released_at = at_once ? 0.0 : 10.0 * (run % 3)});
  }
  results.blocks[0].volume = 0.1;
  results.blocks[1].volume = 0.2;
  return results;
}

// Runs 1 and 2 are of the first realisation, 3 and 5 of the second; run 1 passes the first line
// three times and counts once.
TEST(BarrierPassages, AreTheCountedCrossingsOfEachRealisation) {
  const Comparison comparison = compared(results_that_stay(true));
  const std::vector<RealisationCrossings> all = collect_barrier_crossings(comparison);
  ASSERT_EQ(all.size(), 4u);
  const RealisationCrossings &first = all[0], &second = all[1];
  EXPECT_EQ(first.line, 0u);
  EXPECT_EQ(first.realisation, 0u);
  EXPECT_EQ(first.blocks, 3u);
  ASSERT_EQ(first.passages.size(), 2u);
  EXPECT_EQ(first.first(), 1.0);
  EXPECT_EQ(first.last(), 1.5);
  // Energies are 150 v^2 + 50 J at 2 and 4 m/s; both pass within half a second.
  EXPECT_EQ(first.max_blocks_in_window.value, 2.0);
  EXPECT_EQ(first.max_mass_in_window.value, 600.0);
  EXPECT_NEAR(first.max_energy_in_window.value, 650.0 + 2450.0, 1e-9);
  EXPECT_NEAR(first.largest_energy, 2450.0, 1e-9);
  EXPECT_NEAR(first.sum([](const BlockCrossing& passage) { return passage.volume; }), 0.2, 1e-12);
  // In order of time, not of runs: run 5 passes before run 3.
  ASSERT_EQ(second.passages.size(), 2u);
  EXPECT_EQ(comparison.rows[second.passages[0].row].record->run, 5u);
  EXPECT_EQ(second.max_mass_in_window.value, 800.0);
  // Nothing of the first realisation passes the second line.
  EXPECT_TRUE(all[2].passages.empty());
  EXPECT_TRUE(std::isnan(all[2].first()));
  EXPECT_EQ(all[2].max_energy_in_window.value, 0.0);
  EXPECT_EQ(all[3].passages.size(), 1u);
}

TEST(BarrierPassages, AreByTheClockOfTheRealisation) {
  const std::vector<RealisationCrossings> all =
      collect_barrier_crossings(compared(results_that_stay(false)));
  EXPECT_EQ(all[0].first(), 11.0);
  EXPECT_EQ(all[0].last(), 21.5);
  EXPECT_EQ(all[0].max_blocks_in_window.value, 1.0);
}

TEST(BarrierPassages, AreNoneWhereNoBlockStayed) {
  EXPECT_TRUE(collect_barrier_crossings(compared(hand_made_results())).empty());
}

TEST(PassageCurve, IsTheMeanAndTheRangeOfWhatHasPassed) {
  RealisationCrossings first, second, none;
  first.passages = passages_at({1.0, 2.0});
  second.passages = passages_at({4.0});
  const RealisationCurve curve = passage_curve({&first, &second, &none}, one);
  const auto at = [&](double time) {
    std::size_t i = 0;
    while (i + 1 < curve.time.size() && curve.time[i + 1] <= time) ++i;
    return i;
  };
  EXPECT_EQ(curve.time.front(), 0.0);
  EXPECT_EQ(curve.time.back(), 4.0);
  EXPECT_EQ(curve.mean[at(0.9)], 0.0);
  EXPECT_NEAR(curve.mean[at(1.5)], 1.0 / 3.0, 1e-12);
  EXPECT_NEAR(curve.mean[at(3.0)], 2.0 / 3.0, 1e-12);
  EXPECT_EQ(curve.minimum[at(3.0)], 0.0);
  EXPECT_EQ(curve.maximum[at(3.0)], 2.0);
  EXPECT_NEAR(curve.mean.back(), 1.0, 1e-12);
  EXPECT_TRUE(passage_curve({&none}, one).time.empty());
}

}  // namespace
}  // namespace clast
