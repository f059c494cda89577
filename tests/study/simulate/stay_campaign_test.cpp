// Campaigns whose blocks stay where they stop.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>

#include "study/compare/comparison.hpp"
#include "tests/study/campaign_run.hpp"
#include "tests/study/results_equal.hpp"

namespace clast {
namespace {

class StayCampaign : public CampaignRun {
 protected:
  /// Three realisations of both boxes, dropped at one place of the flat.
  static std::string text(const std::string& blocks = "") {
    std::string text = replaced_once(
        campaign_text(), "points = [[-12, -3, 9.5], [-12, 3, 9.5]]",
        "points = [[10, 0], [10, 0.3]]\nheight_m = 0.4\nsequence = \"stay\"\nrealisations = 3");
    text = replaced_once(text, "\"turns.txt\"", "{ random = 4, fresh = true }");
    text = replaced_once(text, "[terrain]", blocks + "[terrain]");
    return text +
           "[contact.blocks]\nenergy_restitution = 0.1\nfriction = 0.5\nrolling_friction = 0.2\n";
  }
  static std::string changed(const std::string& from, const std::string& to) {
    return replaced_once(text(), from, to);
  }
  static CampaignResults run(const std::string& file, const CampaignRunOptions& options = {},
                             const std::string& of = text()) {
    run_campaign(prepared(of), *folder_ / file, options);
    return read_results(*folder_ / file);
  }
  static void expect_same(const CampaignResults& a, const CampaignResults& b) {
    ASSERT_EQ(a.runs.size(), b.runs.size());
    for (std::size_t i = 0; i < a.runs.size(); ++i) {
      expect_equal(a.runs[i].result.final_state, b.runs[i].result.final_state);
      EXPECT_EQ(a.runs[i].result.path_length, b.runs[i].result.path_length);
    }
    ASSERT_EQ(a.persistent_block_records.size(), b.persistent_block_records.size());
    for (std::size_t i = 0; i < a.persistent_block_records.size(); ++i) {
      EXPECT_EQ(a.persistent_block_records[i].run, b.persistent_block_records[i].run);
      EXPECT_EQ(a.persistent_block_records[i].released_at,
                b.persistent_block_records[i].released_at);
      EXPECT_EQ(a.persistent_block_records[i].later_displacement,
                b.persistent_block_records[i].later_displacement);
      EXPECT_EQ(a.persistent_block_records[i].blocks_hit, b.persistent_block_records[i].blocks_hit);
      EXPECT_EQ(std::isnan(a.persistent_block_records[i].removed_at),
                std::isnan(b.persistent_block_records[i].removed_at));
    }
    EXPECT_FALSE(a.energies.empty());
    expect_equal_energies(a, b);
  }
};

TEST_F(StayCampaign, NeedsContactsThatReturnAtMostHalfOfTheEnergy) {
  const std::string between = "[contact.blocks]\nenergy_restitution = ";
  EXPECT_NO_THROW(prepared(changed(between + "0.1", between + "0.5")));
  const std::string why = refusal(changed(between + "0.1", between + "0.51"));
  EXPECT_TRUE(contains(why, "energy_restitution = 0.51 returns more than half")) << why;
  EXPECT_TRUE(contains(why, "Give at most 0.5, or release the blocks one at a time")) << why;
}

TEST_F(StayCampaign, ReleasesEachBlockOfEachRealisationOntoThoseBeforeIt) {
  const CampaignResults results = run("stay.h5");
  ASSERT_EQ(results.runs.size(), 6u);
  ASSERT_EQ(results.persistent_block_records.size(), 6u);
  EXPECT_EQ(results.persistent_blocks->blocks_per_realisation, 2u);
  EXPECT_EQ(results.persistent_blocks->between_blocks.friction, 0.5);
  for (std::size_t first = 0; first < 6; first += 2) {
    const RunRecord &one = results.runs[first], &other = results.runs[first + 1];
    EXPECT_NE(one.block, other.block);
    EXPECT_EQ(one.stiffness.normal, other.stiffness.normal);
    EXPECT_EQ(one.result.stop_reason, StopReason::kRest);
    EXPECT_EQ(other.result.stop_reason, StopReason::kRest);
    EXPECT_EQ(results.persistent_block_records[first].released_at, 0.0);
    EXPECT_EQ(results.persistent_block_records[first].raise_height, 0.0);
    EXPECT_EQ(results.persistent_block_records[first + 1].released_at, one.result.duration);
    EXPECT_GT(results.persistent_block_records[first + 1].raise_height,
              0.1);  // above the one that lies there
    EXPECT_EQ(results.persistent_block_records[first + 1].blocks_hit, 1u);
    EXPECT_TRUE(std::isnan(results.persistent_block_records[first].removed_at));
    EXPECT_LT(other.result.energy.error, 1e-2);
  }
  // Not three times the same.
  std::set<double> ends;
  for (const RunRecord& record : results.runs) ends.insert(record.result.final_state.position.x());
  EXPECT_EQ(ends.size(), 6u);
}

TEST_F(StayCampaign, IsTheSameOnThreadsInShardsAndAfterAnInterruption) {
  const CampaignResults whole = run("whole.h5", {.threads = 1});
  expect_same(whole, run("threads.h5", {.threads = 3}));
  const CampaignPlan plan = prepared(text());
  expect_same(whole, run_in_shards(plan, 2));
  EXPECT_EQ(read_results(*folder_ / "part1.h5").runs.size(), 4u);  // whole realisations
  const auto quit = [](const ProgressUpdate& step) {
    if (step.done >= 2) throw SimulationError("stopped");
  };
  EXPECT_THROW(run_campaign(plan, *folder_ / "cut.h5", {.threads = 1, .progress = quit}),
               SimulationError);
  run_campaign(plan, *folder_ / "cut.h5", {.threads = 2, .resume = true});
  expect_same(whole, read_results(*folder_ / "cut.h5"));
}

// Whoever watches hears of a realisation before it is over, and can end it there.
TEST_F(StayCampaign, EndsWithinARealisation) {
  std::string slow = changed("realisations = 3", "realisations = 1");
  slow = replaced_once(slow, "[contact.blocks]", "[contact]\ntime_step_s = 1e-8\n[contact.blocks]");
  const CampaignPlan plan = prepared(slow);
  std::string heard;
  const auto quit = [&](const ProgressUpdate& step) {
    heard = step.activity;
    EXPECT_EQ(step.done, 0u);
    throw SimulationError("stopped");
  };
  EXPECT_TRUE(contains(clast::refusal<SimulationError>([&] {
                         run_campaign(plan, *folder_ / "endless.h5",
                                      {.threads = 1, .progress = quit});
                       }),
                       "stopped"));
  EXPECT_TRUE(contains(heard, "realisation 1: "));
  EXPECT_TRUE(contains(heard, " s simulated"));
  EXPECT_FALSE(std::filesystem::exists(*folder_ / "endless.h5"));
}

// Ended within a realisation again and again, whatever is observed on the way is kept.
TEST_F(StayCampaign, GoesOnFromWhereItWasEndedWithinARealisation) {
  std::string slow = changed("realisations = 3", "realisations = 1");
  slow = replaced_once(slow, "[contact.blocks]", "[contact]\ntime_step_s = 4e-6\n[contact.blocks]");
  slow = replaced_once(slow, "[run]",
                       "[[barrier]]\nname = \"fence\"\nfrom = [9.9, -5]\n"
                       "to = [10.1, 5]\n[run]\ntrajectory_interval_s = 0.05");
  const CampaignPlan plan = prepared(slow);
  const std::filesystem::path file = *folder_ / "ended.h5";
  const std::filesystem::path checkpoint = file.string() + ".part.1";
  std::string heard;
  const auto quit = [&](const ProgressUpdate& step) {
    heard = step.activity;
    if (step.done == 0) throw SimulationError("stopped");
  };
  int ends = 0;
  for (bool ended = true; ended; ++ends) {
    ASSERT_LT(ends, 100);
    const std::string before = std::exchange(heard, "");
    try {
      run_campaign(plan, file, {.threads = 1, .resume = true, .progress = quit});
      ended = false;
    } catch (const SimulationError&) {
      EXPECT_TRUE(std::filesystem::exists(checkpoint));
      EXPECT_NE(heard, before);  // it goes on
    }
  }
  EXPECT_GT(ends, 2);
  EXPECT_FALSE(std::filesystem::exists(checkpoint));
  run_campaign(plan, *folder_ / "at-once.h5", {.threads = 2});
  const CampaignResults whole = read_results(*folder_ / "at-once.h5"), parts = read_results(file);
  expect_same(whole, parts);
  ASSERT_FALSE(whole.crossings.empty());
  ASSERT_EQ(whole.crossings.size(), parts.crossings.size());
  ASSERT_EQ(whole.impacts.size(), parts.impacts.size());
  for (std::size_t i = 0; i < whole.impacts.size(); ++i) {
    expect_equal(whole.impacts[i], parts.impacts[i]);
  }
  for (std::size_t i = 0; i < whole.runs.size(); ++i) expect_equal(whole.runs[i], parts.runs[i]);
  EXPECT_EQ(read_trajectory(file, 1).time, read_trajectory(*folder_ / "at-once.h5", 1).time);
}

TEST_F(StayCampaign, KeepsACheckpointNowAndThen) {
  const CampaignPlan plan = prepared(text());
  const std::filesystem::path file = *folder_ / "kept.h5";
  std::set<std::string> seen;
  const auto look = [&](const ProgressUpdate&) {
    for (const auto& entry : std::filesystem::directory_iterator(file.parent_path())) {
      const std::string name = entry.path().filename().string();
      if (name.starts_with("kept.h5.part.")) seen.insert(name);
    }
  };
  run_campaign(plan, file, {.threads = 1, .progress = look, .checkpoint_interval = 1e-3});
  // Each is there when its realisation is added, and goes then.
  EXPECT_EQ(seen, (std::set<std::string>{"kept.h5.part.1", "kept.h5.part.2", "kept.h5.part.3"}));
  look({});
  EXPECT_FALSE(std::filesystem::exists(file.string() + ".part.3"));
}

// Blocks that have come to rest say what the others will take, not the time limit of each.
TEST_F(StayCampaign, AProbeThatIsCutShortCountsBlocksThatRest) {
  const std::string many =
      replaced_once(text("draw = { count = 40 }\n"), "realisations = 3", "realisations = 1");
  const CampaignPlan plan = prepared(many);
  const RunTimeProbe whole = measure_run_time(plan, 1e3);
  ASSERT_FALSE(whole.last_run_stopped);
  ASSERT_EQ(whole.runs, 40u);
  const RunTimeProbe cut =
      measure_run_time(plan, whole.time_per_run * 40.0 / 15.0);  // stops after a third
  EXPECT_TRUE(cut.last_run_stopped);
  EXPECT_FALSE(cut.is_upper_bound);
  EXPECT_LT(cut.time_per_run, 5.0 * whole.time_per_run);
  EXPECT_GT(cut.time_per_run, 0.2 * whole.time_per_run);
}

TEST_F(StayCampaign, GoesOnInTheMiddleOfARealisation) {
  const CampaignResults whole = run("all.h5");
  const CampaignPlan plan = prepared(text());
  {
    ResultsWriter writer = ResultsWriter::create(*folder_ / "half.h5", plan.header, 6);
    StoredRun first;
    first.record = whole.runs[0];
    first.persistent_block_records = {whole.persistent_block_records[0]};
    for (const EnergyRecord& record : whole.energies) {
      if (record.run == 0) first.energies.push_back(record);
    }
    writer.add(first);
  }
  run_campaign(plan, *folder_ / "half.h5", {.resume = true});
  expect_same(whole, read_results(*folder_ / "half.h5"));
}

TEST_F(StayCampaign, ReleasesInTheListedOrderOrInADrawnOne) {
  const auto orders = [](const CampaignPlan& plan) {
    std::set<std::vector<std::uint32_t>> found;
    for (std::size_t i = 0; i < plan.runs.size(); i += 2) {
      found.insert({plan.runs[i].block, plan.runs[i + 1].block});
    }
    return found;
  };
  const std::string many = changed("realisations = 3", "realisations = 20");
  EXPECT_EQ(orders(prepared(many)).size(), 2u);
  const auto listed = orders(
      prepared(replaced_once(many, "realisations = 20", "realisations = 20\norder = \"listed\"")));
  EXPECT_EQ(listed, (std::set<std::vector<std::uint32_t>>{{0, 1}}));
  // More realisations leave the first ones as they are.
  const CampaignPlan few = prepared(text()), more = prepared(many);
  for (std::size_t i = 0; i < few.runs.size(); ++i) {
    EXPECT_EQ(few.runs[i].block, more.runs[i].block);
    EXPECT_EQ(few.runs[i].start.position, more.runs[i].start.position);
  }
}

TEST_F(StayCampaign, DrawsBlocksAnewForEachRealisation) {
  const std::string draw =
      "draw = { count = 3, shares = { compact = 0.34, elongated = 0.66 }, mass_kg = { uniform = "
      "[200, 400] } }\n";
  const CampaignPlan plan = prepared(text(draw));
  ASSERT_EQ(plan.runs.size(), 9u);
  EXPECT_EQ(plan.header.persistent_blocks->blocks_per_realisation, 3u);
  std::set<double> masses;
  for (std::size_t first = 0; first < 9; first += 3) {
    std::map<std::string, int> classes;
    for (std::size_t i = first; i < first + 3; ++i) {
      const BlockSummary& block = plan.header.blocks[plan.runs[i].block];
      ++classes[block.garcia];
      masses.insert(block.mass);
    }
    EXPECT_EQ(classes["compact"], 1);
    EXPECT_EQ(classes["elongated"], 2);
  }
  EXPECT_EQ(masses.size(), 9u);
}

TEST_F(StayCampaign, ShareTheGroundOfAMemberOfTheEnsemble) {
  const std::string uncertain =
      replaced_once(changed("friction = 0.6", "friction = { uniform = [0.5, 0.7] }"), "[run]",
                    "[ensemble]\nmembers = 2\n[run]");
  const CampaignPlan plan = prepared(uncertain);
  std::vector<std::uint32_t> sets;
  for (const RunRecord& run : plan.runs) sets.push_back(run.ground_set);
  EXPECT_EQ(sets, (std::vector<std::uint32_t>{0, 0, 1, 1, 0, 0}));
}

TEST_F(StayCampaign, RunsOfARealisationAreOneClusterOfTheTests) {
  std::vector<CampaignResults> results;
  results.push_back(run("compared.h5", {}, changed("realisations = 3", "realisations = 6")));
  const Comparison comparison = compare(std::move(results));
  ASSERT_FALSE(comparison.differences.empty());
  for (const GroupDifference& difference : comparison.differences) EXPECT_EQ(difference.points, 6u);
}

TEST_F(StayCampaign, ClearsAZoneAfterEachRelease) {
  const std::string cleared =
      changed("sequence = \"stay\"", "sequence = \"stay\"\nremove = { zone = \"flat\" }");
  const CampaignResults results = run("cleared.h5", {}, cleared);
  ASSERT_EQ(results.persistent_block_records.size(), 6u);
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_EQ(results.runs[i].result.stop_reason, StopReason::kRest);
    EXPECT_EQ(results.persistent_block_records[i].raise_height, 0.0);
    EXPECT_EQ(results.persistent_block_records[i].blocks_hit, 0u);
    EXPECT_EQ(results.persistent_block_records[i].later_displacement, 0.0);
    EXPECT_EQ(results.persistent_block_records[i].removed_at,
              results.persistent_block_records[i].released_at + results.runs[i].result.duration);
  }
  // A zone that no block rests in changes nothing.
  const std::string elsewhere =
      changed("sequence = \"stay\"", "sequence = \"stay\"\nremove = { zone = [\"slope\"] }");
  expect_same(run("stay.h5", {.replace = true}), run("elsewhere.h5", {}, elsewhere));
}

TEST_F(StayCampaign, RefusesWhatDoesNotFit) {
  const auto refused = [](const std::string& text, const std::string& part) {
    EXPECT_TRUE(contains(clast::refusal([&] { campaign(text); }), part));
  };
  refused(changed("sequence = \"stay\"\n", ""),
          "[release] realisations = 3: applies to persistent blocks; add sequence = \"stay\"");
  refused(changed("\"stay\"", "\"stays\""), "sequence = \"stays\": must be \"single\" or \"stay\"");
  refused(changed("realisations = 3", "realisations = 0"), "realisations = 0: must be from 1");
  const auto removes = [](const std::string& what) {
    return changed("realisations = 3", "realisations = 3\nremove = " + what);
  };
  refused(removes("\"flat\""), "remove = \"flat\": must be { zone = \"NAME\" }");
  refused(removes("{ zone = \"road\" }"),
          "zone = \"road\": \"road\" is not a ground zone; zones are flat, slope");
  refused(removes("{ zone = [\"flat\", \"flat\"] }"), "names \"flat\" more than once");
  refused(removes("{ zones = \"flat\" }"), "unknown key");
  refused(replaced_once(removes("{ zone = \"flat\" }"), "sequence = \"stay\"\n", ""),
          "applies to persistent blocks");
  refused(changed("[contact.blocks]\nenergy_restitution = 0.1\n", "[contact.blocks]\n"),
          "[contact.blocks]: energy_restitution is missing");
  refused(changed("[contact.blocks]\n", "[contact.blocks]\nscar_drag = 1.5\n"), "unknown key");
  refused(replaced_once(campaign_text(), "[run]",
                        "[contact.blocks]\nenergy_restitution = 0.1\nfriction = 0.5\n"
                        "rolling_friction = 0.2\n[run]"),
          "[contact.blocks] applies to persistent blocks");
  std::string without = text();
  refused(without.substr(0, without.find("[contact.blocks]")), "add [contact.blocks]");
  refused(replaced_once(text("draw = { count = 3 }\n"), "realisations = 3",
                        "realisations = 3\norder = \"listed\""),
          "drawn blocks have no order");
  refused(text() +
              "[[block_group]]\nname = \"g\"\nselect = [\"cube\"]\nground.flat = { friction "
              "= 0.5 }\n",
          "leave the block groups out");
}

}  // namespace
}  // namespace clast
