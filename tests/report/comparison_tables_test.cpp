#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "core/files/text_file.hpp"
#include "core/random.hpp"
#include "report/comparison_report.hpp"
#include "report/tables/comparison_provenance.hpp"
#include "study/compare/comparison.hpp"
#include "tests/study/csv_reader.hpp"
#include "tests/study/hand_made_results.hpp"
#include "tests/study/table_csv.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/scratch_folder.hpp"

namespace clast {
namespace {

TEST(RunsTable, StartsWithTheAgreedColumns) {
  const std::string text = table_csv(compared(hand_made_results()), "runs");
  EXPECT_TRUE(text.starts_with(
      "run,block,class,shape,point,orientation,stop_reason,duration_s,stop_x_m,stop_y_m,stop_z_m,"
      "runout_m,lateral_deg,max_speed_m_s,max_penetration_m,energy_error,"));
}

TEST(RunsTable, ReadsBackToTheSameBits) {
  CampaignResults results = hand_made_results();
  Random random(3);
  for (RunRecord& run : results.runs) {
    run.result.final_state.position = Vec3(40.0, 20.0, 10.0).cwiseProduct(random.unit_vector());
    run.result.duration = 1.0 / 3.0 + random.uniform();
  }
  const Comparison comparison = compared(std::move(results));
  const CsvTable table = read_csv(table_csv(comparison, "runs"));
  ASSERT_EQ(table.rows.size(), comparison.rows.size());
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    const RunRow& row = comparison.rows[i];
    EXPECT_EQ(table.rows[i].at("block"), row.block->id);
    EXPECT_EQ(table.rows[i].at("class"), row.block->sneed_folk);
    EXPECT_EQ(table.rows[i].at("shape"), row.block->garcia);
    EXPECT_EQ(table.rows[i].at("stop_reason"), "rest");
    EXPECT_EQ(table.number(i, "stop_x_m"), row.stop.x());
    EXPECT_EQ(table.number(i, "stop_y_m"), row.stop.y());
    EXPECT_EQ(table.number(i, "stop_z_m"), row.stop.z());
    EXPECT_EQ(table.number(i, "duration_s"), row.record->result.duration);
    EXPECT_EQ(table.number(i, "runout_m"), row.runout);
    EXPECT_NEAR(table.number(i, "lateral_deg"), row.lateral * 180.0 / kPi, 1e-12);
  }
}

TEST(RunsTable, UnknownNumbersAreEmptyAndMessagesSurviveTheirCommas) {
  CampaignResults results = hand_made_results();
  results.runs[1].result.stop_reason = StopReason::kError;
  results.runs[1].result.message = "step 3, block \"a\"\nlost";
  results.runs[1].result.final_state.position = Vec3::Constant(NAN);
  const CsvTable table = read_csv(table_csv(compared(std::move(results)), "runs"));
  EXPECT_EQ(table.rows[1].at("stop_x_m"), "");
  EXPECT_EQ(table.rows[1].at("runout_m"), "");
  EXPECT_EQ(table.rows[1].at("message"), "step 3, block \"a\"\nlost");
}

TEST(BarriersTable, HoldsTheSummariesOfEveryGroup) {
  const CsvTable table = read_csv(table_csv(compared(hand_made_results()), "barriers"));
  EXPECT_EQ(table.rows.size(), 14u);  // two barriers, seven groups
  const std::size_t compact = table.find("group", "class compact");
  EXPECT_EQ(table.rows[compact].at("barrier"), "B<1>");
  EXPECT_EQ(table.number(compact, "runs"), 4.0);
  EXPECT_EQ(table.number(compact, "crossings"), 3.0);
  EXPECT_EQ(table.number(compact, "probability"), 0.75);
  EXPECT_NEAR(table.number(compact, "speed_mean_m_s"), 4.0, 1e-12);
  EXPECT_NEAR(table.number(compact, "speed_p95_m_s"), 5.8, 1e-12);
  EXPECT_NEAR(table.number(compact, "translational_energy_max_j"), 5400.0, 1e-9);
  EXPECT_NEAR(table.number(compact, "rotational_energy_median_j"), 50.0, 1e-12);
  EXPECT_NEAR(table.number(compact, "rotation_rate_std_rad_s"), 0.0, 1e-12);
  EXPECT_NEAR(table.number(compact, "height_mean_m"), 1.0, 1e-12);
}

TEST(BarriersTable, GroupWithoutCrossingsHasEmptyStatistics) {
  const CsvTable table = read_csv(table_csv(compared(hand_made_results()), "barriers"));
  for (const auto& row : table.rows) {
    if (row.at("barrier") != "B2" || row.at("group") != "class elongated") continue;
    EXPECT_EQ(row.at("crossings"), "0");
    EXPECT_EQ(row.at("probability"), "0");
    EXPECT_EQ(row.at("speed_mean_m_s"), "");
    return;
  }
  FAIL() << "no row of B2 and the elongated class";
}

TEST(CrossingsTable, HoldsAllInOrderOfRunAndTimeOnTheMap) {
  CampaignResults results = hand_made_results();
  std::reverse(results.crossings.begin(), results.crossings.end());
  const CsvTable table = read_csv(table_csv(compared(std::move(results)), "crossings"));
  ASSERT_EQ(table.rows.size(), 7u);
  const std::vector<std::string> runs = {"1", "1", "1", "2", "3", "3", "5"};
  for (std::size_t i = 0; i < 7; ++i) EXPECT_EQ(table.rows[i].at("run"), runs[i]);
  EXPECT_EQ(table.rows[1].at("direction"), "backward");
  EXPECT_EQ(table.rows[0].at("counted"), "1");
  EXPECT_EQ(table.rows[2].at("counted"), "0");
  EXPECT_EQ(table.number(0, "x_m"), kMapOrigin.x() + 10.0);
  EXPECT_EQ(table.number(0, "z_m"), kMapOrigin.z() - 4.0);
  EXPECT_NEAR(table.number(0, "total_energy_j"), 650.0, 1e-9);
}

// Run 1 starts inside, leaves, comes back and leaves again; run 3 enters and leaves. A ring that
// runs clockwise stores its exits backward.
TEST(BarriersTable, ARingCountsItsFirstEntryAndItsFirstExit) {
  for (const bool counter_clockwise : {true, false}) {
    CampaignResults results = hand_made_results();
    std::vector<Vec2>& ring = results.barriers[0].vertices;
    ring = {Vec2(8, -9), Vec2(12, -9), Vec2(12, 9), Vec2(8, 9), Vec2(8, -9)};
    if (!counter_clockwise) std::reverse(ring.begin(), ring.end());
    const auto crossing = [&](std::uint32_t run, double time, double speed, bool out) {
      Crossing made = hand_made_crossing(run, 0, time, speed);
      made.forward = out == counter_clockwise;
      return made;
    };
    results.crossings = {crossing(1, 1.0, 2.0, true), crossing(1, 2.0, 3.0, false),
                         crossing(1, 3.0, 9.0, true), crossing(3, 1.2, 6.0, false),
                         crossing(3, 1.4, 4.0, true)};
    const Comparison comparison = compared(std::move(results));
    const CsvTable crossings = read_csv(table_csv(comparison, "crossings"));
    const std::vector<std::array<const char*, 3>> expected = {{"B<1> (out)", "out", "1"},
                                                              {"B<1> (in)", "in", "1"},
                                                              {"B<1> (out)", "out", "0"},
                                                              {"B<1> (in)", "in", "1"},
                                                              {"B<1> (out)", "out", "1"}};
    ASSERT_EQ(crossings.rows.size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) {
      EXPECT_EQ(crossings.rows[i].at("barrier"), expected[i][0]);
      EXPECT_EQ(crossings.rows[i].at("direction"), expected[i][1]);
      EXPECT_EQ(crossings.rows[i].at("counted"), expected[i][2]);
    }
    const CsvTable barriers = read_csv(table_csv(comparison, "barriers"));
    const std::size_t in = barriers.find("barrier", "B<1> (in)"),
                      out = barriers.find("barrier", "B<1> (out)");
    EXPECT_EQ(barriers.rows[in].at("group"), "all");
    EXPECT_EQ(barriers.rows[in].at("crossings"), "2");
    EXPECT_EQ(barriers.rows[out].at("crossings"), "2");
    EXPECT_NEAR(barriers.number(in, "speed_mean_m_s"), (3.0 + 6.0) / 2.0, 1e-12);
    EXPECT_NEAR(barriers.number(out, "speed_mean_m_s"), (2.0 + 4.0) / 2.0, 1e-12);
  }
}

TEST(DepositsTable, HoldsEveryGroupInDegreesAndMapMetres) {
  const CsvTable table = read_csv(table_csv(compared(hand_made_results()), "deposits"));
  EXPECT_EQ(table.rows.size(), 7u);
  const std::size_t elongated = table.find("group", "class elongated");
  EXPECT_EQ(table.number(elongated, "count"), 2.0);
  EXPECT_NEAR(table.number(elongated, "runout_mean_m"), 15.0, 1e-9);
  EXPECT_NEAR(table.number(elongated, "lateral_std_deg"), 45.0 * std::sqrt(2.0), 1e-9);
  EXPECT_NEAR(table.number(elongated, "mean_stop_y_m"), kMapOrigin.y() + 5.0, 1e-8);
  EXPECT_EQ(table.number(elongated, "downslope_x"), 1.0);
}

TEST(Tables, HaveTheSameBytesForEqualResultsInFilesOfOtherNames) {
  CampaignResults renamed = hand_made_results();
  renamed.file = "elsewhere/eight-threads.h5";
  const Comparison a = compared(hand_made_results()), b = compared(std::move(renamed));
  EXPECT_EQ(table_csv(a, "runs"), table_csv(b, "runs"));
  EXPECT_EQ(table_csv(a, "barriers"), table_csv(b, "barriers"));
  EXPECT_EQ(table_csv(a, "crossings"), table_csv(b, "crossings"));
  EXPECT_EQ(table_csv(a, "deposits"), table_csv(b, "deposits"));
}

TEST(ImpactsTable, HoldsEveryImpactOnTheMap) {
  CampaignResults results = hand_made_results();
  Impact impact;
  impact.run = 3;
  impact.zone = 1;
  impact.time = 2.5;
  impact.contact_duration = 0.03;
  impact.position = Vec3(12.0, 1.0, -6.0);
  impact.speed_before = 9.0;
  impact.translational_after = 1000.0;
  impact.depth = 0.02;
  results.impacts = {impact, impact};
  results.impacts[1].run = 5;
  const CsvTable table = read_csv(table_csv(compared(std::move(results)), "impacts"));
  ASSERT_EQ(table.rows.size(), 2u);
  EXPECT_EQ(table.rows[0].at("run"), "3");
  EXPECT_EQ(table.rows[0].at("block"), "round<1>");
  EXPECT_EQ(table.rows[1].at("block"), "long, \"2\"");
  EXPECT_EQ(table.rows[0].at("zone"), "scree");
  EXPECT_EQ(table.number(0, "x_m"), 900012.0);
  EXPECT_EQ(table.number(0, "z_m"), 194.0);
  EXPECT_EQ(table.number(0, "speed_before_m_s"), 9.0);
  EXPECT_EQ(table.number(0, "translational_energy_after_j"), 1000.0);
  EXPECT_EQ(table.number(0, "depth_m"), 0.02);
}

TEST(GroundSetsTable, HoldsTheParametersOfEveryZone) {
  CampaignResults results = hand_made_results();
  results.ground_sets = {{"", 0, results.ground},
                         {"schist", 0, {{0.02, 0.5, 0.1}, {0.03, 0.4, 0.2}}}};
  const CsvTable table = read_csv(table_csv(compared(std::move(results)), "ground_sets"));
  ASSERT_EQ(table.rows.size(), 4u);
  EXPECT_EQ(table.rows[3].at("block_group"), "schist");
  EXPECT_EQ(table.rows[3].at("zone"), "scree");
  EXPECT_EQ(table.number(3, "rolling_friction"), 0.2);
}

TEST(WriteComparison, LeavesTheWholeSetAndNothingElse) {
  const ScratchFolder folder;
  write_comparison(compared(hand_made_results()), folder / "out");
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder / "out")) {
    names.push_back(entry.path().filename().string());
  }
  std::sort(names.begin(), names.end());
  EXPECT_EQ(names, (std::vector<std::string>{"barriers.csv",
                                             "crossings.csv",
                                             "deposits.csv",
                                             "differences.csv",
                                             "effects.csv",
                                             "energies.csv",
                                             "ensemble.csv",
                                             "ground_sets.csv",
                                             "impacts.csv",
                                             "mobility.csv",
                                             "passage_curves.csv",
                                             "passages.csv",
                                             "profiles.csv",
                                             "provenance.json",
                                             "realisation_differences.csv",
                                             "realisation_figures.csv",
                                             "realisations.csv",
                                             "report.html",
                                             "responses.csv",
                                             "runs.csv",
                                             "stays.csv",
                                             "stops.gpkg",
                                             "trends.csv"}));
  EXPECT_TRUE(contains(read_text_file(folder / "out" / "provenance.json"), std::string(64, 'c')));
}

TEST(ProvenanceJson, HasTheStiffnessOfEveryBlock) {
  CampaignResults results = hand_made_results();
  results.runs[0].impact_depth = 0.05;
  for (RunRecord& run : results.runs) run.settled_depth = std::nan("");
  const auto json = nlohmann::json::parse(make_provenance_json(compared(std::move(results))));
  const nlohmann::json& blocks = json["files"][0]["stiffness"];
  ASSERT_EQ(blocks.size(), 2u);
  EXPECT_EQ(blocks[0]["block"], "round<1>");
  EXPECT_EQ(blocks[0]["stiffness_n_m"], (std::vector<double>{1e8, 1e8}));
  EXPECT_EQ(blocks[0]["impact_depth_m"], (std::vector<double>{0.05, 0.1}));
  EXPECT_EQ(blocks[1]["stiffness_n_m"], (std::vector<double>{3e8, 4e8}));
  EXPECT_EQ(blocks[1]["rolling_stiffness_n_m_rad"], (std::vector<double>{2e7, 2e7}));
  EXPECT_EQ(blocks[1]["time_step_s"], (std::vector<double>{1e-5, 1e-5}));
  EXPECT_TRUE(blocks[1]["rest_depth_m"].is_null()) << "of a file that does not hold it";
}

TEST(WriteComparison, FileInPlaceOfTheFolderIsRefused) {
  const ScratchFolder folder;
  write_text_file(folder / "out", "taken");
  EXPECT_THROW(write_comparison(compared(hand_made_results()), folder / "out"), InputError);
  EXPECT_EQ(read_text_file(folder / "out"), "taken");
}

}  // namespace
}  // namespace clast
