#include "study/simulate/campaign_runner.hpp"

#include <gtest/gtest.h>

#include <set>

#include "core/error.hpp"
#include "tests/study/campaign_run.hpp"
#include "tests/study/results_equal.hpp"

namespace clast {
namespace {

namespace fs = std::filesystem;

TEST_F(CampaignRun, EveryRunIsStoredWithItsCrossingsAndTrajectory) {
  const CampaignPlan plan = prepared();
  const fs::path target = *folder_ / "all.h5";
  std::size_t calls = 0;
  run_campaign(plan, target, {.threads = 2, .progress = [&](const ProgressUpdate& step) {
                                EXPECT_EQ(step.done, ++calls);
                                EXPECT_EQ(step.total, 12u);
                              }});
  EXPECT_EQ(calls, 12u);
  const CampaignResults results = read_results(target);
  ASSERT_EQ(results.runs.size(), 12u);
  std::set<std::uint32_t> crossed;
  for (const Crossing& crossing : results.crossings) {
    EXPECT_NEAR(crossing.position.x() + results.frame.origin.x(), 0.0, 1e-8);
    crossed.insert(crossing.run);
  }
  EXPECT_FALSE(crossed.empty());
  for (const RunRecord& run : results.runs) {
    EXPECT_NE(run.result.stop_reason, StopReason::kError) << run.result.message;
    EXPECT_FALSE(run.result.below_ground);
    // Who ends on the flat has crossed its edge.
    const double stop_x = results.frame.to_map(run.result.final_state.position).x();
    EXPECT_EQ(stop_x > 0.0, crossed.count(run.run) == 1) << run.run;
    const Trajectory trajectory = read_trajectory(target, run.run);
    ASSERT_GE(trajectory.time.size(), 2u);
    EXPECT_EQ(trajectory.states.front().position, run.start.position);
    EXPECT_EQ(trajectory.time.back(), run.result.duration);
    EXPECT_LT((trajectory.states.back().position - run.result.final_state.position).norm(), 1e-12);
    EXPECT_NEAR(trajectory.time[1], 0.1, 1e-15);
    // Free fall until something is touched.
    EXPECT_NEAR(trajectory.states[1].position.z(), run.start.position.z() - 0.5 * 9.81 * 0.01,
                1e-9);
  }
}

TEST_F(CampaignRun, ResultsDoNotDependOnThreadsOrInterruptions) {
  const CampaignPlan plan = prepared();
  run_campaign(plan, *folder_ / "one.h5", {.threads = 1});
  run_campaign(plan, *folder_ / "two.h5", {.threads = 2});
  expect_equal_results(*folder_ / "one.h5", *folder_ / "two.h5");

  // Stopped twice from outside, and torn at its end.
  struct Stop {};
  for (int stop = 0; stop < 2; ++stop) {
    const auto quit = [](const ProgressUpdate& step) {
      if (step.done % 4 == 0) throw Stop{};
    };
    EXPECT_THROW(
        run_campaign(plan, *folder_ / "cut.h5", {.threads = 1, .resume = true, .progress = quit}),
        Stop);
    const fs::path part = results_journal_path(*folder_ / "cut.h5");
    ASSERT_TRUE(fs::exists(part));
    EXPECT_FALSE(fs::exists(*folder_ / "cut.h5"));
    fs::resize_file(part, fs::file_size(part) - 7);
  }
  std::size_t runs = 0;
  run_campaign(plan, *folder_ / "cut.h5",
               {.threads = 2, .resume = true, .progress = [&](const ProgressUpdate&) { ++runs; }});
  EXPECT_LT(runs, 12u);
  expect_equal_results(*folder_ / "one.h5", *folder_ / "cut.h5");
  EXPECT_FALSE(fs::exists(results_journal_path(*folder_ / "cut.h5")));
}

TEST_F(CampaignRun, RunThatFailsIsStoredWithItsReason) {
  CampaignPlan plan = prepared();
  plan.runs[5].start.position.z() -= 20.0;
  const fs::path target = *folder_ / "failed.h5";
  run_campaign(plan, target, {.threads = 2});
  const CampaignResults results = read_results(target);
  ASSERT_EQ(results.runs.size(), 12u);
  for (const RunRecord& run : results.runs) {
    EXPECT_EQ(run.result.stop_reason == StopReason::kError, run.run == 5) << run.run;
    EXPECT_EQ(run.result.message.empty(), run.run != 5) << run.run;
  }
  EXPECT_EQ(results.runs[5].result.final_state.position, plan.runs[5].start.position);
}

TEST_F(CampaignRun, TargetThatCantBeWrittenIsRefusedBeforeAnythingRuns) {
  const CampaignPlan plan = prepared();
  fs::create_directory(*folder_ / "folder.h5");
  const auto ran = [](const ProgressUpdate&) { FAIL() << "a run was done"; };
  EXPECT_THROW(run_campaign(plan, *folder_ / "folder.h5", {.progress = ran}), InputError);
  EXPECT_THROW(run_campaign(plan, *folder_ / "turns.txt/r.h5", {.progress = ran}), InputError);
}

TEST_F(CampaignRun, FinishedResultsAreKeptUntilReplaceAndNotRunAgain) {
  const CampaignPlan plan = prepared();
  const fs::path target = *folder_ / "finished.h5";
  run_campaign(plan, target, {.threads = 2});
  const std::string first = read_text_file(target);
  const auto none = [](const ProgressUpdate&) { FAIL() << "a run was done"; };
  EXPECT_THROW(run_campaign(plan, target, {.progress = none}), InputError);
  run_campaign(plan, target, {.resume = true, .progress = none});
  const CampaignPlan other = prepared(with("max_time_s = 6", "max_time_s = 5"));
  try {
    run_campaign(other, target, {.resume = true, .progress = none});
    FAIL();
  } catch (const InputError& error) {
    EXPECT_TRUE(contains(error.what(),
                         "finished.h5: holds the finished results of another "
                         "campaign file; `replace` replaces them"))
        << error.what();
  }
  EXPECT_THROW(run_campaign(plan, target, {.resume = true, .shard = {1, 2}, .progress = none}),
               InputError);
  EXPECT_EQ(read_text_file(target), first);
  run_campaign(other, target, {.threads = 2, .replace = true});
  EXPECT_EQ(read_results(target).campaign_sha256, other.header.campaign_sha256);
}

TEST_F(CampaignRun, ChangedInputsAreNotResumed) {
  const CampaignPlan plan = prepared();
  const fs::path target = *folder_ / "changed.h5";
  struct Stop {};
  EXPECT_THROW(
      run_campaign(plan, target, {.threads = 1, .progress = [](const auto&) { throw Stop{}; }}),
      Stop);
  const CampaignPlan other = prepared(with("max_time_s = 6", "max_time_s = 5"));
  try {
    run_campaign(other, target, {.resume = true});
    FAIL();
  } catch (const InputError& error) {
    EXPECT_TRUE(contains(error.what(), "was begun with another campaign file")) << error.what();
  }
}

}  // namespace
}  // namespace clast
