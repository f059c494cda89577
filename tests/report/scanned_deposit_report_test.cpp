// Contents of reports on the population of a scanned deposit.
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>

#include "report/json/population_json.hpp"
#include "report/pages/population_page.hpp"
#include "report/population_report.hpp"
#include "report/tables/scanned_deposit_tables.hpp"
#include "report/text/scanned_deposit_text.hpp"
#include "tests/classify/deposit_samples.hpp"
#include "tests/support/markup.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/working_folder.hpp"

namespace clast {
namespace {

using namespace report_detail;

PopulationReport deposit_report(bool scanned = true) {
  PopulationReport report;
  report.options.schemes = {"sneed-folk", "garcia"};
  ReportedPopulation reported;
  reported.population = sample_deposit(120, 9).found;
  if (!scanned) {
    for (MeasuredBlock& block : reported.population.blocks) block.deposit.reset();
  }
  reported.summary = summarise_population(reported.population, report.options);
  reported.deposit = summarise_scanned_deposit(reported.population, report.options);
  reported.measured = "sides of the smallest box of the rounded body";
  report.populations.push_back(std::move(reported));
  return report;
}

nlohmann::json json_of(const PopulationReport& report) {
  std::ostringstream out;
  write_population_json(out, report);
  return nlohmann::json::parse(out.str());
}

TEST(ScannedDepositReport, JsonHasSizesClassesAndLongAxes) {
  const PopulationReport report = deposit_report();
  const ScannedDepositSummary& summary = *report.populations[0].deposit;
  const nlohmann::json json = json_of(report);
  const nlohmann::json& deposit = json["deposit"];
  EXPECT_EQ(deposit["blocks"], summary.blocks);
  for (const char* weighting : {"number", "area", "grid", "corrected"}) {
    for (const char* size : {"L_m", "I_m", "S_m", "volume_m3"}) {
      for (const char* name : {"D16", "D50", "D84", "P95"}) {
        const nlohmann::json& one = deposit["sizes"][weighting][size][name];
        EXPECT_LE(one["low"], one["value"]);
        EXPECT_GE(one["high"], one["value"]);
      }
    }
  }
  EXPECT_EQ(deposit["classes"]["sneed-folk"].size(), 10u);
  EXPECT_EQ(deposit["long_axes"]["blocks"], summary.long_axes.trends.size());
  const double probability = json["blocks"][0]["deposit"]["found_probability"];
  EXPECT_GT(probability, 0.0);
  EXPECT_LT(probability, 1.0);
}

TEST(ScannedDepositReport, TablesHaveARowForEachBlockSizeAndClass) {
  const PopulationReport report = deposit_report();
  std::map<std::string, std::size_t> rows;
  for (const PopulationTable& table : scanned_deposit_tables()) {
    rows[table.name] = count_of(table.csv(report), "\n") - 1;
  }
  EXPECT_EQ(rows["scanned_blocks"], report.populations[0].population.blocks.size());
  EXPECT_EQ(rows["scanned_sizes"], 4u * 4u * 4u);
  EXPECT_EQ(rows["scanned_shares"], 10u + 2u);
}

TEST(ScannedDepositReport, PageHasTheSectionAndIsWellFormed) {
  const PopulationReport report = deposit_report();
  const std::string html = make_population_page(report, draw_population_diagrams(report));
  EXPECT_EQ(unbalanced(html), "");
  EXPECT_TRUE(contains(html, "What the surface shows and hides"));
  EXPECT_TRUE(contains(html, "north (+y)"));
  EXPECT_EQ(html.find(">nan"), std::string::npos);
  EXPECT_TRUE(
      contains(format_scanned_deposit(*report.populations[0].deposit), "by number, corrected"));
}

class DepositFolder : public WorkingFolder {};

TEST_F(DepositFolder, OtherPopulationsKeepTheirFilesAndJson) {
  const PopulationReport report = deposit_report(false);
  EXPECT_FALSE(report.populations[0].deposit);
  EXPECT_FALSE(json_of(report).contains("deposit"));
  EXPECT_FALSE(json_of(report)["blocks"][0].contains("deposit"));
  std::filesystem::create_directory("plain");
  write_population_report(report, "plain");
  EXPECT_FALSE(std::filesystem::exists("plain/scanned_sizes.csv"));
  EXPECT_FALSE(std::filesystem::exists("plain/long_axes.svg"));
  std::filesystem::create_directory("scanned");
  write_population_report(deposit_report(), "scanned");
  for (const char* file : {"scanned_blocks.csv", "scanned_shares.csv", "scanned_sizes.csv",
                           "long_axes.svg", "found_sizes.svg"}) {
    EXPECT_TRUE(std::filesystem::exists(std::filesystem::path("scanned") / file)) << file;
  }
}

}  // namespace
}  // namespace clast
