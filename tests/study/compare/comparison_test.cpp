#include "study/compare/comparison.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/random.hpp"
#include "study/results/runout.hpp"
#include "tests/study/hand_made_results.hpp"
#include "tests/support/refusal.hpp"

namespace clast {
namespace {

std::size_t group_index(const Comparison& comparison, const std::string& name) {
  for (std::size_t g = 0; g < comparison.groups.size(); ++g) {
    if (comparison.groups[g].name == name) return g;
  }
  ADD_FAILURE() << "no group " << name;
  return 0;
}

const DepositStatistics& deposit(const Comparison& comparison, const std::string& name) {
  return comparison.deposits[group_index(comparison, name)];
}

const BarrierGroupStatistics& at_barrier(const Comparison& comparison, const std::string& barrier,
                                         const std::string& group) {
  for (const BarrierGroupStatistics& one : comparison.barriers) {
    if (one.barrier == barrier && one.group == group) return one;
  }
  throw std::runtime_error("no group " + group + " at " + barrier);
}

bool warns(const Comparison& comparison, const std::string& words) {
  for (const std::string& warning : comparison.warnings) {
    if (warning.find(words) != std::string::npos) return true;
  }
  return false;
}

std::string refused(std::vector<CampaignResults> results) {
  return refusal([&] { compare(std::move(results)); });
}

std::string refused(const CampaignResults& results) {
  return refused(std::vector<CampaignResults>{results});
}

TEST(RunoutMeasures, IsMeasuredAlongDownslope) {
  const Vec2 down = Vec2(3.0, 4.0).normalized();
  const RunoutMeasures measured = compute_runout(Vec3(1, 1, 9), Vec3(7, 9, 0), down);
  EXPECT_NEAR(measured.along, 10.0, 1e-12);
  EXPECT_NEAR(measured.lateral, 0.0, 1e-12);
}

TEST(RunoutMeasures, LateralIsPositiveToTheRightLookingDownslope) {
  // Looking along +x with z up, the right hand is -y; looking along +y it is +x.
  EXPECT_NEAR(compute_runout(Vec3::Zero(), Vec3(5, -5, 0), Vec2::UnitX()).lateral, kPi / 4, 1e-15);
  EXPECT_NEAR(compute_runout(Vec3::Zero(), Vec3(5, 5, 0), Vec2::UnitX()).lateral, -kPi / 4, 1e-15);
  EXPECT_NEAR(compute_runout(Vec3::Zero(), Vec3(5, 5, 0), Vec2::UnitY()).lateral, kPi / 4, 1e-15);
}

TEST(RunoutMeasures, UphillIsNegativeAndBehind) {
  const RunoutMeasures measured = compute_runout(Vec3::Zero(), Vec3(-2, 0, 1), Vec2::UnitX());
  EXPECT_DOUBLE_EQ(measured.along, -2.0);
  EXPECT_NEAR(std::abs(measured.lateral), kPi, 1e-15);
}

TEST(RunoutMeasures, OfABlockThatStaysIsZero) {
  const RunoutMeasures measured = compute_runout(Vec3(1, 2, 3), Vec3(1, 2, 2), Vec2::UnitX());
  EXPECT_EQ(measured.along, 0.0);
  EXPECT_EQ(measured.lateral, 0.0);
}

TEST(RunoutMeasures, TurnsWithTheSite) {
  Random random(7);
  for (int i = 0; i < 50; ++i) {
    const Vec3 start = 10.0 * random.unit_vector(), stop = 50.0 * random.unit_vector();
    const Eigen::Rotation2Dd turn(random.uniform(-kPi, kPi));
    const Eigen::AngleAxisd turn3(turn.angle(), Vec3::UnitZ());
    const RunoutMeasures before = compute_runout(start, stop, Vec2::UnitX());
    const RunoutMeasures after = compute_runout(turn3 * start, turn3 * stop, turn * Vec2::UnitX());
    EXPECT_NEAR(after.along, before.along, 1e-12);
    EXPECT_NEAR(std::sin(after.lateral - before.lateral), 0.0, 1e-12);
  }
}

TEST(Compare, GroupsAreAllBlocksAndClassesThatOccur) {
  std::vector<std::string> names;
  const Comparison comparison = compared(hand_made_results());
  for (const RunGroup& group : comparison.groups) names.push_back(group.name);
  std::sort(names.begin(), names.end());
  EXPECT_EQ(names,
            (std::vector<std::string>{"all", "block long, \"2\"", "block round<1>", "class compact",
                                      "class elongated", "sneed-folk C", "sneed-folk VE"}));
}

TEST(Compare, OneSneedFolkClassGetsNoGroupOfItsOwn) {
  CampaignResults results = hand_made_results();
  results.blocks[1].sneed_folk = "C";
  for (const RunGroup& group : compared(std::move(results)).groups) {
    EXPECT_NE(group.kind, RunGroupKind::kSneedFolk);
  }
}

TEST(Compare, DepositsAreAsComputedByHand) {
  const Comparison comparison = compared(hand_made_results());
  const DepositStatistics& compact = deposit(comparison, "class compact");
  EXPECT_EQ(compact.runout.count, 4u);
  EXPECT_NEAR(compact.runout.mean, 25.0, 1e-9);
  EXPECT_NEAR(compact.runout.std, std::sqrt(500.0 / 3.0), 1e-9);
  EXPECT_NEAR(compact.runout.median, 25.0, 1e-9);
  EXPECT_NEAR(compact.runout.p95, 38.5, 1e-9);
  EXPECT_NEAR(compact.runout.max, 40.0, 1e-9);
  EXPECT_LT((compact.mean_stop - (kMapOrigin + Vec3(25.0, 0.0, -12.5))).norm(), 1e-9);

  const DepositStatistics& elongated = deposit(comparison, "block long, \"2\"");
  EXPECT_NEAR(elongated.runout.mean, 15.0, 1e-9);
  EXPECT_NEAR(elongated.lateral.mean, 0.0, 1e-9);  // 45 degrees right and 45 left
  EXPECT_NEAR(elongated.lateral.std, kPi / 4 * std::sqrt(2.0), 1e-9);
}

TEST(Compare, OnlyRunsAtRestAreDeposits) {
  CampaignResults results = hand_made_results();
  results.runs[3].result.stop_reason = StopReason::kLeftTerrain;
  results.runs[2].result.stop_reason = StopReason::kMaxTime;
  results.runs[1].result.stop_reason = StopReason::kError;
  results.runs[1].result.final_state.position = Vec3::Constant(NAN);
  const Comparison comparison = compared(std::move(results));
  const DepositStatistics& compact = deposit(comparison, "class compact");
  EXPECT_EQ(compact.started, 4u);
  EXPECT_EQ(compact.stops.rest, 1u);
  EXPECT_EQ(compact.stops.left_terrain, 1u);
  EXPECT_EQ(compact.stops.max_time, 1u);
  EXPECT_EQ(compact.stops.error, 1u);
  EXPECT_NEAR(compact.runout.mean, 10.0, 1e-9);
  EXPECT_TRUE(warns(comparison, "1 of 6 runs left the surveyed terrain"));
  EXPECT_TRUE(warns(comparison, "1 of 6 runs were still moving at max_time"));
  EXPECT_TRUE(warns(comparison, "1 of 6 runs failed with an error"));
}

TEST(Compare, DownslopeDefaultsToTheMeanLineFromReleaseToStop) {
  CampaignResults results = hand_made_results();
  results.downslope.reset();
  // Offsets sum to (130, 10).
  const Comparison comparison = compared(std::move(results));
  EXPECT_FALSE(comparison.downslope_given);
  EXPECT_LT((comparison.downslope - Vec2(13.0, 1.0).normalized()).norm(), 1e-9);
}

TEST(Compare, AskedDownslopeIsMadeUnit) {
  const Comparison comparison = compared(hand_made_results());
  EXPECT_TRUE(comparison.downslope_given);
  EXPECT_EQ(comparison.downslope, Vec2(1.0, 0.0));
}

TEST(Compare, StopsAtTheReleaseLeaveDownslopeUndefined) {
  CampaignResults results = hand_made_results();
  results.downslope.reset();
  for (RunRecord& run : results.runs) run.result.final_state.position = run.start.position;
  const Comparison comparison = compared(std::move(results));
  EXPECT_TRUE(warns(comparison, "downslope is undefined"));
  EXPECT_EQ(comparison.downslope, Vec2::UnitX());
  EXPECT_EQ(deposit(comparison, "all").runout.max, 0.0);
}

TEST(Compare, FirstCrossingCounts) {
  const Comparison comparison = compared(hand_made_results());
  const BarrierGroupStatistics& compact = at_barrier(comparison, "B<1>", "class compact");
  EXPECT_EQ(compact.started, 4u);
  EXPECT_EQ(compact.crossed, 3u);
  EXPECT_DOUBLE_EQ(compact.probability, 0.75);
  EXPECT_NEAR(compact.speed.mean, 4.0, 1e-12);  // 2, 4 and 6; the 9 is the second passage
  EXPECT_NEAR(compact.speed.max, 6.0, 1e-12);
  EXPECT_NEAR(compact.total.mean, 150.0 * (4.0 + 16.0 + 36.0) / 3.0 + 50.0, 1e-9);
  EXPECT_NEAR(compact.rotation_rate.mean, 5.0, 1e-12);
  EXPECT_NEAR(compact.clearance.median, 0.25, 1e-12);
  // A box of 1.0, 0.9 and 0.8 m reaches half its diagonal from its centre, which passes at 1 m.
  EXPECT_NEAR(compact.top.max, 1.0 + 0.5 * std::sqrt(1.0 + 0.81 + 0.64), 1e-12);
  EXPECT_DOUBLE_EQ(at_barrier(comparison, "B2", "all").probability, 1.0 / 6.0);
  EXPECT_EQ(at_barrier(comparison, "B2", "class elongated").crossed, 0u);
}

/// All runs cross B<1> from the right of its line to its left.
CampaignResults results_with_a_barrier_drawn_the_wrong_way() {
  CampaignResults results = hand_made_results();
  for (Crossing& crossing : results.crossings) crossing.forward = !crossing.forward;
  return results;
}

TEST(Compare, ABarrierDrawnTheWrongWayCountsTheSameRuns) {
  const Comparison comparison = compared(results_with_a_barrier_drawn_the_wrong_way());
  const BarrierGroupStatistics& compact = at_barrier(comparison, "B<1>", "class compact");
  EXPECT_EQ(compact.counted, "either");
  EXPECT_EQ(compact.crossed, 3u);
  EXPECT_EQ(compact.backward, 3u);
  EXPECT_NEAR(compact.speed.mean, 4.0, 1e-12);
  EXPECT_FALSE(warns(comparison, "in the opposite direction"));
}

TEST(Compare, OfAStatedDirectionOnlyThatCountsAndMostlyTheOtherIsWarnedOf) {
  CampaignResults results = results_with_a_barrier_drawn_the_wrong_way();
  results.barriers[0].counted = CountedDirection::kForward;
  const Comparison comparison = compared(results);
  const BarrierGroupStatistics& compact = at_barrier(comparison, "B<1>", "class compact");
  EXPECT_EQ(compact.counted, "forward");
  EXPECT_EQ(compact.crossed, 1u) << "that came back";
  EXPECT_EQ(compact.backward, 3u);
  EXPECT_TRUE(warns(comparison, "barrier B<1> counts only"));
  EXPECT_TRUE(warns(comparison, "of 6 runs first crossed it in the opposite direction"));
  for (Crossing& crossing : results.crossings) crossing.forward = !crossing.forward;
  EXPECT_FALSE(warns(compared(std::move(results)), "first crossed it in the opposite direction"));
}

TEST(Compare, UnequalMassesAreNamed) {
  EXPECT_TRUE(warns(compared(hand_made_results()), "mass differs between classes"));
  CampaignResults equal = hand_made_results();
  equal.blocks[1].mass = equal.blocks[0].mass;
  EXPECT_FALSE(warns(compared(std::move(equal)), "mass differs between classes"));
}

TEST(Compare, UnfinishedBelowGroundAndUnbalancedRunsAreCounted) {
  CampaignResults results = hand_made_results();
  results.planned_runs = 8;
  results.runs[0].result.below_ground = true;
  results.runs[1].result.energy.error = 0.5;
  results.runs[2].result.energy.error = NAN;
  results.warnings = {"stiffness is softer than auto"};
  const Comparison comparison = compared(std::move(results));
  EXPECT_TRUE(warns(comparison, "6 of 8 planned runs"));
  EXPECT_TRUE(warns(comparison, "1 of 6 runs ended below ground"));
  EXPECT_TRUE(warns(comparison, "2 of 6 runs have an error of more than 1 %"));
  EXPECT_TRUE(warns(comparison, "stiffness is softer than auto"));
}

TEST(Compare, EnergyThatContactsLoseOrGainIsNamedAboveATenthOfTheDissipated) {
  CampaignResults results = hand_made_results();
  for (RunRecord& run : results.runs) {
    run.result.energy.normal = 700.0;
    run.result.energy.friction = 200.0;
    run.result.energy.rolling = 100.0;
    run.result.energy.reassigned = 99.0;
  }
  EXPECT_FALSE(warns(compared(results), "lose or gain more than"));
  results.runs[2].result.energy.reassigned = 250.0;
  results.runs[5].result.energy.reassigned = -101.0;
  const Comparison comparison = compared(std::move(results));
  EXPECT_TRUE(warns(comparison, "2 of 6 runs lose or gain more than 10 %"));
  EXPECT_TRUE(warns(comparison, "at most 25 %, run 2, block round<1>"));
  EXPECT_FALSE(reassigned_energy_fraction(EnergyBalance()));
}

// Blocks of one mass on a slope of 26.6 deg that brakes what rolls: atan 0.6 = 31 deg.
CampaignResults clean_results() {
  CampaignResults results = hand_made_results();
  results.blocks[1].mass = results.blocks[0].mass;
  results.ground = {{0.01, 0.7, 0.6}, {0.01, 0.7, 0.6}};
  return results;
}

TEST(Compare, SlopesWhereGeometryDecidesAreNamed) {
  CampaignResults results = hand_made_results();
  for (RunRecord& run : results.runs) {
    if (run.result.final_state.position.x() > 20.0) run.result.stop_reason = StopReason::kMaxTime;
  }
  const Comparison comparison = compared(std::move(results));
  EXPECT_TRUE(warns(comparison,
                    "zone blue slopes 26.6 deg on average, between atan mu_R = 19.3 deg and atan "
                    "mu = 35 deg: "));
  EXPECT_TRUE(warns(comparison,
                    "zone scree slopes 26.6 deg on average, above atan mu = 16.7 deg: friction "
                    "cannot stop a block there"));
  // No run reached the scree.
  CampaignResults upper = hand_made_results();
  for (RunRecord& run : upper.runs) run.result.final_state.position = Vec3(5.0, 0.0, -2.5);
  const Comparison short_runs = compared(std::move(upper));
  EXPECT_TRUE(warns(short_runs, "zone blue slopes"));
  EXPECT_FALSE(warns(short_runs, "zone scree slopes"));
}

TEST(Compare, ZoneThatStopsBlocksIsNotCalledTooSteepToStopThem) {
  CampaignResults results = hand_made_results();
  const auto at_rest_on_scree = [&](std::size_t count) {
    for (std::size_t i = 0; i < results.runs.size(); ++i) {
      results.runs[i].result.stop_reason = StopReason::kRest;
      results.runs[i].result.final_state.position =
          i < count ? Vec3(30.0, 0.0, -15.0) : Vec3(5.0, 0.0, -2.5);
    }
    return compared(results);
  };
  const Comparison some = at_rest_on_scree(2);
  EXPECT_TRUE(warns(some, "but 2 of 6 runs stopped on its flatter parts"));
  EXPECT_FALSE(warns(some, "friction cannot stop a block there"));
  for (const ComparisonWarning& caution : some.cautions) {
    EXPECT_FALSE(contains(caution.brief, "too steep")) << caution.brief;
  }
}

TEST(Compare, CleanRunsOfEqualMassGiveNoWarning) {
  CampaignResults results = clean_results();
  EXPECT_TRUE(compared(std::move(results)).warnings.empty());
}

TEST(Compare, WarningOfAllFilesIsSaidOnce) {
  CampaignResults first = clean_results(), second = first;
  first.warnings = {"soft", "common"};
  second.warnings = {"common", "hard"};
  EXPECT_EQ(compared(first, second).warnings,
            (std::vector<std::string>{"file 1: soft", "common", "file 2: hard"}));
}

TEST(Compare, TwoFilesAreGroupedTogetherAndEachAlone) {
  CampaignResults second = hand_made_results();
  second.runs.resize(3);
  second.crossings.resize(3);
  second.planned_runs = 3;
  const Comparison comparison = compared(hand_made_results(), std::move(second));
  EXPECT_EQ(deposit(comparison, "all").started, 9u);
  EXPECT_EQ(deposit(comparison, "file 1: all").started, 6u);
  EXPECT_EQ(deposit(comparison, "file 2: class compact").started, 3u);
  EXPECT_EQ(comparison.lines.size(), 2u);  // the same lines in both files
  EXPECT_EQ(at_barrier(comparison, "B<1>", "all").started, 9u);
  EXPECT_EQ(at_barrier(comparison, "B<1>", "file 2: all").crossed, 1u);
}

// Nobody knows whether a run that failed would have passed.
TEST(Compare, ARunThatFailedDoesNotCountAtBarriers) {
  CampaignResults results = hand_made_results();
  const std::size_t crossed = at_barrier(compared(results), "B<1>", "all").crossed;
  results.runs[2].result.stop_reason = StopReason::kError;
  const Comparison comparison = compared(std::move(results));
  EXPECT_EQ(at_barrier(comparison, "B<1>", "all").started, 5u);
  EXPECT_EQ(at_barrier(comparison, "B<1>", "all").crossed, crossed - 1);
}

TEST(Compare, BarrierOfOneFileCountsOnlyThatFilesRuns) {
  CampaignResults second = hand_made_results();
  second.barriers[0].vertices[0].y() = -5.0;  // another line under the same name
  const Comparison comparison = compared(hand_made_results(), std::move(second));
  EXPECT_EQ(comparison.lines.size(), 3u);
  EXPECT_EQ(at_barrier(comparison, "B<1>", "all").started, 6u);
  EXPECT_EQ(at_barrier(comparison, "B<1> (file 2)", "all").started, 6u);
  EXPECT_THROW(at_barrier(comparison, "B<1>", "file 2: all"), std::runtime_error);
}

TEST(Compare, NoFileOrNoRunsIsRefused) {
  EXPECT_TRUE(contains(refused(std::vector<CampaignResults>{}), "no runs to compare"));
  CampaignResults results = hand_made_results();
  results.runs.clear();
  results.crossings.clear();
  EXPECT_TRUE(contains(refused(results), "hand-made.h5"));
}

TEST(Compare, RunsGivenTwiceAreRefused) {
  CampaignResults copy = hand_made_results();
  copy.file = "copy.h5";
  EXPECT_TRUE(contains(refused({hand_made_results(), copy}), "copy.h5: holds the same runs as"));
  // Runs of another clast, or on changed inputs, are worth comparing.
  CampaignResults newer = copy, changed = copy;
  newer.program_version += "-next";
  changed.inputs.front() += "0";
  EXPECT_EQ(refused({hand_made_results(), newer, changed}), "");
}

TEST(Compare, DifferentMapFramesAreRefused) {
  CampaignResults moved = hand_made_results(), other_crs = hand_made_results();
  moved.campaign_sha256 = other_crs.campaign_sha256 = std::string(64, 'd');
  moved.frame.origin.x() += 1.0;
  other_crs.frame.crs = "EPSG:2154";
  EXPECT_TRUE(contains(refused({hand_made_results(), moved}), "map frame"));
  EXPECT_TRUE(contains(refused({hand_made_results(), other_crs}), "EPSG:2154"));
}

TEST(Compare, DifferentDownslopesAreRefused) {
  CampaignResults other = hand_made_results();
  other.campaign_sha256 = std::string(64, 'd');
  other.downslope = Vec2(0.0, 1.0);
  EXPECT_TRUE(contains(refused({hand_made_results(), other}), "downslope"));
  other.downslope = Vec2(0.0, 0.0);
  EXPECT_TRUE(contains(refused({other}), "not a direction"));
}

TEST(Compare, RecordsThatFitNothingAreRefused) {
  CampaignResults block = hand_made_results(), stop = block, run = block, barrier = block,
                  twice = block;
  block.runs[4].block = 2;
  EXPECT_TRUE(contains(refused(block), "run 4 refers to block number 2 of 2"));
  stop.runs[3].result.final_state.position.x() = NAN;
  EXPECT_TRUE(contains(refused(stop), "run 3"));
  run.crossings[0].run = 99;
  EXPECT_TRUE(contains(refused(run), "run 99"));
  barrier.crossings[0].barrier = 7;
  EXPECT_TRUE(contains(refused(barrier), "barrier number 7"));
  twice.runs[1].run = 0;
  EXPECT_TRUE(contains(refused(twice), "run 0 is stored twice"));
}

TEST(ComparisonWarnings, SpeedsThatAreSeldomSeenAreQuestioned) {
  for (const auto& [speed, questioned] : {std::pair(28.0, false), {36.0, true}}) {
    CampaignResults results = hand_made_results();
    for (RunRecord& run : results.runs) run.result.max_speed = speed;
    const Comparison comparison = compared(std::move(results));
    const bool said =
        std::any_of(comparison.cautions.begin(), comparison.cautions.end(),
                    [](const ComparisonWarning& caution) {
                      return caution.brief.find("5 % of the runs exceed a speed of 36 m/s") !=
                             std::string::npos;
                    });
    EXPECT_EQ(said, questioned) << speed;
  }
  // One fast run of many is no reason.
  CampaignResults results = hand_made_results();
  for (RunRecord& run : results.runs) run.result.max_speed = 10.0;
  for (std::uint32_t i = 6; i < 60; ++i) {
    results.runs.push_back(results.runs[i % 6]);
    results.runs.back().run = i;
  }
  results.runs[7].result.max_speed = 80.0;
  results.planned_runs = 60;
  for (const ComparisonWarning& caution : compared(std::move(results)).cautions) {
    EXPECT_EQ(caution.brief.find("faster"), std::string::npos) << caution.brief;
  }
}

}  // namespace
}  // namespace clast
