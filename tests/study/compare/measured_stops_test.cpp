#include "study/compare/measured_stops.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include <cmath>

#include "core/files/text_file.hpp"
#include "report/tables/comparison_provenance.hpp"
#include "tests/study/csv_reader.hpp"
#include "tests/study/hand_made_results.hpp"
#include "tests/study/table_csv.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/scratch_folder.hpp"

namespace clast {
namespace {

Comparison against(const std::string& table, const ScratchFolder& folder) {
  write_text_file(folder / "seen.csv", table);
  std::vector<CampaignResults> all;
  all.push_back(hand_made_results());
  return compare(std::move(all), {.by = {}, .measured = folder / "seen.csv", .margin = {}});
}

// Runs start over (900000, 6500000) and stop 10, 20, 30, 40 m (compact) and 10, 20 m (elongated)
// on.
TEST(MeasuredStops, AreHeldAgainstSimulatedOnesOfTheirGroup) {
  const ScratchFolder folder;
  const Comparison comparison = against(
      "x_m;y_m;shape\n900025;6500000;compact\n900035;6500000;compact\n900015;6500015;elongated\n",
      folder);
  const CsvTable table = read_csv(table_csv(comparison, "measured"));
  const std::size_t all = table.find("group", "all");
  EXPECT_EQ(table.rows[all].at("measured"), "3");
  EXPECT_EQ(table.rows[all].at("simulated"), "6");
  EXPECT_NEAR(table.number(all, "runout_mean_m"), 25.0, 1e-9);
  EXPECT_NEAR(table.number(all, "simulated_runout_mean_m"), 130.0 / 6.0, 1e-9);
  EXPECT_NEAR(table.number(all, "difference_m"), 25.0 - 130.0 / 6.0, 1e-9);
  const std::size_t compact = table.find("group", "class compact");
  EXPECT_NEAR(table.number(compact, "runout_mean_m"), 30.0, 1e-9);
  EXPECT_NEAR(table.number(compact, "runout_std_m"), std::sqrt(50.0), 1e-9);
  // 25 beats two of four, 35 three of four.
  EXPECT_NEAR(table.number(compact, "cliffs_delta"), (2 - 2 + 3 - 1) / 8.0, 1e-12);
  const std::size_t elongated = table.find("group", "class elongated");
  EXPECT_NEAR(table.number(elongated, "lateral_mean_deg"), -45.0, 1e-6);
  EXPECT_NE(make_provenance_json(comparison).find("seen.csv"), std::string::npos);
}

TEST(MeasuredStops, QuartilesAndIntervalsStandBesideTheMeans) {
  const ScratchFolder folder;
  // Compact blocks are simulated at 10, 20, 30, 40 m; measured 100 m farther.
  const Comparison comparison = against(
      "x,y,shape\n900110,6500000,compact\n900120,6500000,compact\n"
      "900130,6500000,compact\n900140,6500000,compact\n",
      folder);
  const CsvTable table = read_csv(table_csv(comparison, "measured"));
  const std::size_t compact = table.find("group", "class compact");
  EXPECT_NEAR(table.number(compact, "runout_q25_m"), 117.5, 1e-9);
  EXPECT_NEAR(table.number(compact, "runout_q75_m"), 132.5, 1e-9);
  EXPECT_NEAR(table.number(compact, "simulated_runout_q25_m"), 17.5, 1e-9);
  EXPECT_NEAR(table.number(compact, "simulated_runout_median_m"), 25.0, 1e-9);
  EXPECT_NEAR(table.number(compact, "simulated_runout_q75_m"), 32.5, 1e-9);
  EXPECT_NEAR(table.number(compact, "median_difference_m"), 100.0, 1e-9);
  // Any draw of four from each leaves a difference of medians from 70 to 130 m.
  const double low = table.number(compact, "median_difference_low_m"),
               high = table.number(compact, "median_difference_high_m");
  EXPECT_GE(low, 70.0);
  EXPECT_LT(low, 100.0);
  EXPECT_GT(high, 100.0);
  EXPECT_LE(high, 130.0);
  // The samples do not overlap, however they are drawn.
  EXPECT_EQ(table.number(compact, "ks_distance"), 1.0);
  EXPECT_EQ(table.number(compact, "ks_distance_low"), 1.0);
  EXPECT_EQ(table.number(compact, "ks_distance_high"), 1.0);
}

TEST(MeasuredStops, MayNameTheirOwnStart) {
  const ScratchFolder folder;
  const Comparison comparison =
      against("x,y,start_x,start_y\n900025,6500000,900005,6500000\n", folder);
  EXPECT_NEAR(comparison.measured->stops[0].runout, 20.0, 1e-9);
}

TEST(MeasuredStops, TablesOfAnyProgramAreReadAlike) {
  const ScratchFolder folder;
  for (const char* table :
       {"x,y,block\n900050.5,6500000.25,round<1>\n", "x;y;block\n900050,5;6500000,25;round<1>\n",
        "\xef\xbb\xbf\"X_m\"\tY_m\tblock\r\n900050,5\t6500000,25\tround<1>\r\n",
        "x y block\n900050,5 6500000,25 round<1>\n"}) {
    const Comparison comparison = against(table, folder);
    ASSERT_EQ(comparison.measured->stops.size(), 1u) << table;
    EXPECT_EQ(comparison.measured->stops[0].position, Vec2(900050.5, 6500000.25)) << table;
    EXPECT_EQ(comparison.measured->stops[0].block, "round<1>") << table;
  }
}

TEST(MeasuredStops, NamesThatNothingHasAndPlacesOffTheTerrainAreTold) {
  const ScratchFolder folder;
  const auto warns = [&](const std::string& table, const std::string& part) {
    const Comparison comparison = against(table, folder);
    return std::any_of(comparison.warnings.begin(), comparison.warnings.end(),
                       [&](const std::string& warning) { return contains(warning, part); });
  };
  const std::string good = "900020,6500000";
  EXPECT_FALSE(
      warns("x,y,block,shape\n" + good + ",round<1>,compact\n" + good + ",,\n", "measured stops"));
  EXPECT_TRUE(warns("x,y,block\n" + good + ",nobody\n" + good + ",round<1>\n",
                    "1 of 2 measured stops name a block that was not simulated"));
  EXPECT_TRUE(warns("x,y,shape\n" + good + ",round\n",
                    "1 of 1 measured stops have a shape other than compact or elongated"));
  EXPECT_TRUE(warns("x,y\n5,7\n", "1 of 1 measured stops lie outside the terrain"));
}

TEST(MeasuredStops, TablesThatAreNoneAreRefused) {
  const ScratchFolder folder;
  const auto refused = [&](const std::string& table) {
    return refusal([&] { against(table, folder); });
  };
  EXPECT_TRUE(contains(refused(""), "is empty"));
  EXPECT_TRUE(contains(refused("x,z\n1,2\n"), "seen.csv:1: has no column \"y\""));
  EXPECT_TRUE(contains(refused("x,y\n1,two\n"), "seen.csv:2: y \"two\" is not a number"));
  EXPECT_TRUE(contains(refused("x,y\n1\n"), "seen.csv:2: has 1 field, but line 1 has 2"));
  EXPECT_TRUE(contains(refused("x,y\n1,\n"), "seen.csv:2: y \"\" is not a number"));
  EXPECT_TRUE(contains(refused("x,y\n1,1e308\n"), "seen.csv:2: y \"1e308\" is not a number from"));
  // (900050.5, 6500000.25) of a program that writes decimal commas.
  EXPECT_TRUE(
      contains(refused("x,y\n900050,5,6500000,25\n"),
               "seen.csv:2: has 4 fields, but line 1 has 2; where commas are decimal signs"));
  EXPECT_TRUE(
      contains(refused("x,y\n\"900050,5\",6500000\n"), "seen.csv:2: x \"900050,5\" is not a "));
  EXPECT_TRUE(contains(refused("x,y\n"), "holds no stop"));
  EXPECT_TRUE(contains(refused("x,X_m,y\n1,2,3\n"), "seen.csv:1: has two columns \"x\""));
  EXPECT_TRUE(contains(refused("x,y,start_x\n1,2,3\n"), "has only one of start_x and start_y"));
}

}  // namespace
}  // namespace clast
