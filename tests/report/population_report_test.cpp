#include "report/population_report.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "core/files/text_file.hpp"
#include "core/random.hpp"
#include "core/utf8.hpp"
#include "report/charts/class_fraction_chart.hpp"
#include "report/charts/form_diagram.hpp"
#include "report/charts/svg_chart.hpp"
#include "report/charts/ticks.hpp"
#include "report/html/html_page.hpp"
#include "report/json/population_json.hpp"
#include "report/pages/population_page.hpp"
#include "report/tables/population_tables.hpp"
#include "tests/study/csv_reader.hpp"
#include "tests/support/markup.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/scratch_folder.hpp"

namespace clast {
namespace {

using namespace report_detail;

Population blocks(const std::string& name, std::size_t count, bool weighed = true) {
  Random random(count);
  Population population{name, {}};
  for (std::size_t i = 0; i < count; ++i) {
    const Axes axes = Axes::sorted(std::exp(0.4 * random.normal()), std::exp(0.4 * random.normal()),
                                   std::exp(0.4 * random.normal()));
    population.blocks.push_back(make_measured_block(
        "b<" + std::to_string(i) + ">", axes,
        weighed ? std::optional(2600.0 * axes.L * axes.I * axes.S) : std::nullopt));
  }
  return population;
}

PopulationReport report_of(std::vector<Population> populations) {
  PopulationReport report;
  report.options.schemes = {"sneed-folk", "zingg", "garcia"};
  for (Population& population : populations) {
    ReportedPopulation reported;
    reported.summary = summarise_population(population, report.options);
    reported.population = std::move(population);
    reported.measured = "as in the table";
    reported.inputs = {{"talus.csv", std::string(64, 'a')}};
    reported.notes = {"row 7 skipped: S is missing"};
    report.populations.push_back(std::move(reported));
  }
  if (report.populations.size() > 1) {
    report.comparison = compare_populations(report.populations[0].population,
                                            report.populations[1].population, report.options);
  }
  return report;
}

std::string page_of(const PopulationReport& report) {
  return make_population_page(report, draw_population_diagrams(report));
}

class Sizes : public testing::TestWithParam<std::size_t> {};
INSTANTIATE_TEST_SUITE_P(Blocks, Sizes, testing::Values(1, 3, 89, 3000));

TEST_P(Sizes, PageAndPicturesAreWellFormedAndNeedNothingElse) {
  const PopulationReport report = report_of({blocks("talus", GetParam())});
  const std::string html = page_of(report);
  EXPECT_EQ(unbalanced(html), "");
  expect_self_contained(html);
  EXPECT_EQ(html.find("\"nan"), std::string::npos);
  EXPECT_EQ(html.find("\"-\""), std::string::npos);  // how a number that is none would be written
  for (const auto& [name, svg] : draw_population_diagrams(report)) {
    const std::string file = make_svg_file(svg);
    EXPECT_EQ(unbalanced(file), "") << name;
    EXPECT_TRUE(file.starts_with("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg width=\"520\""));
    EXPECT_TRUE(contains(file, "font-family"));
  }
}

TEST(PopulationPage, EveryMarkNamesItsBlock) {
  const PopulationReport report = report_of({blocks("talus", 12)});
  const std::string triangle = draw_sneed_folk_diagram(report.populations[0].population, 0);
  for (std::size_t i = 0; i < 12; ++i) {
    const std::string key = "data-block=\"0-" + std::to_string(i) + "\"";
    EXPECT_EQ(count_of(triangle, key), 1u);
    EXPECT_TRUE(contains(triangle, "<title>b&lt;" + std::to_string(i) + "&gt;\nL "));
    // Triangle, Zingg, size by number and by mass.
    EXPECT_EQ(count_of(page_of(report), key), 4u);
  }
}

TEST(PopulationPage, ClassesWithoutABlockAreDrawnToo) {
  const PopulationReport report = report_of({blocks("one", 1)});
  const std::string triangle = draw_sneed_folk_diagram(report.populations[0].population, 0);
  EXPECT_EQ(count_of(triangle, "<polygon"), 10u);
  for (const std::string& name : class_names("sneed-folk")) {
    EXPECT_TRUE(contains(triangle, ">" + name + "</text>"));
    EXPECT_TRUE(contains(triangle, "<title>" + name + ": "));
  }
  const std::string zingg = draw_zingg_diagram(report.populations[0].population, 0);
  EXPECT_EQ(count_of(zingg, "<polygon"), 4u);
  const std::string html = page_of(report);
  for (const std::string& scheme : report.options.schemes) {
    for (const std::string& name : class_names(scheme)) EXPECT_TRUE(contains(html, name));
  }
}

/// The number after `key` in the first element of an SVG that has `part`.
double number_after(const std::string& svg, const std::string& part, const std::string& key) {
  const std::size_t end = svg.find(part);
  const std::size_t begin = svg.rfind('<', end);
  const std::size_t at = svg.find(key, begin);
  return std::strtod(svg.c_str() + at + key.size(), nullptr);
}

// Where the limits meet the left side: heights of the triangle from the base are S/L.
TEST(SneedFolkDiagram, MarksStandWhereTheRatiosSay) {
  Population population{
      "three",
      {make_measured_block("cube", {1, 1, 1}), make_measured_block("plate", {1, 1, 0.001}),
       make_measured_block("needle", {1, 0.001, 0.001})}};
  const std::string svg = draw_sneed_folk_diagram(population, 0);
  const auto x = [&](int i) {
    const std::string key = "data-block=\"0-" + std::to_string(i) + "\"";
    return i < 2 ? number_after(svg, key, " cx=\"") : number_after(svg, key, " d=\"M");
  };
  const double apex = number_after(svg, "data-block=\"0-0\"", " cy=\"");
  const double base = number_after(svg, "data-block=\"0-1\"", " cy=\"");
  EXPECT_NEAR(x(0), 0.5 * (x(1) + x(2)), 0.2);
  EXPECT_NEAR((base - apex) / (x(2) - x(1)), std::sqrt(3.0) / 2.0, 2e-3);
}

TEST(PopulationPage, ManyBlocksAreShownAsADensityAndThatIsSaid) {
  const PopulationReport report = report_of({blocks("many", kMaxSingleBlocks + 1)});
  const std::string html = page_of(report);
  EXPECT_EQ(count_of(html, "data-block=\"0-"), 0u);
  EXPECT_TRUE(contains(html, "show densities"));
  EXPECT_LT(html.size(), 400'000u);
  // Every block is in one of the squares.
  const std::string triangle = draw_sneed_folk_diagram(report.populations[0].population, 0);
  std::size_t counted = 0;
  for (std::size_t at = triangle.find("blocks</title></rect>"); at != std::string::npos;
       at = triangle.find("blocks</title></rect>", at + 1)) {
    const std::size_t begin = triangle.rfind('>', at) + 1;
    counted += std::strtoul(triangle.c_str() + begin, nullptr, 10);
  }
  EXPECT_EQ(counted, kMaxSingleBlocks + 1);
}

TEST(PopulationPage, TwoPopulationsAreComparedInWords) {
  const PopulationReport report = report_of({blocks("P1 & co", 40), blocks("P2", 50, false)});
  const std::string html = page_of(report);
  EXPECT_EQ(unbalanced(html), "");
  EXPECT_TRUE(contains(html, "P1 &amp; co against P2"));
  EXPECT_TRUE(contains(html, "Kolmogorov-Smirnov") && contains(html, "chi-squared"));
  std::set<std::string> names;
  for (const auto& [name, svg] : draw_population_diagrams(report)) names.insert(name);
  EXPECT_EQ(names, (std::set<std::string>{"sneed_folk_1", "sneed_folk_2", "zingg_1", "zingg_2",
                                          "size_1", "size_2", "sizes", "s_c", "shares_sneed_folk",
                                          "shares_zingg", "shares_shape"}));
}

TEST(PopulationPage, BlocksWithBoxesSayWhatTheConventionDecides) {
  Population population = blocks("scans", 5);
  for (MeasuredBlock& block : population.blocks) block.axes_by_box = {4, block.axes};
  population.blocks[0].axes = population.blocks[0].axes_in_table_unit = {1.2, 1.0, 0.9};
  population.blocks[0].axes_by_box = {
      {1.2, 1.0, 0.9}, {1.4, 1.0, 0.9}, {1.4, 1.0, 0.9}, {1.4, 1.0, 0.9}};
  const std::string html = page_of(report_of({population}));
  EXPECT_EQ(unbalanced(html), "");
  EXPECT_TRUE(contains(html, "<h2>Boxes</h2>"));
  EXPECT_TRUE(contains(html, "By the inertia box 1 of 5 blocks has another class of garcia."));
  EXPECT_TRUE(contains(html, "By the pca box none of 5 blocks has another class of zingg."));
  EXPECT_EQ(page_of(report_of({blocks("talus", 5)})).find("<h2>Boxes</h2>"), std::string::npos);
}

TEST(PopulationPage, NotesAreReadFirst) {
  const std::string html = page_of(report_of({blocks("talus", 5)}));
  EXPECT_TRUE(contains(html, "row 7 skipped: S is missing"));
  EXPECT_LT(html.find("row 7 skipped"), html.find("<h2>Classes</h2>"));
}

TEST(PopulationTables, ClassesHoldEveryBlockWithItsClassesAndIndices) {
  const ScratchFolder folder;
  PopulationReport report = report_of({blocks("talus", 5000)});
  report.populations[0].population.blocks.push_back(make_measured_block("cube", {1, 1, 1}));
  write_classes_csv(report, folder / "one.csv", 1);
  write_classes_csv(report, folder / "four.csv", 4);
  const std::string text = read_text_file(folder / "one.csv");
  EXPECT_EQ(text, read_text_file(folder / "four.csv"));
  const CsvTable table = read_csv(text);
  ASSERT_EQ(table.rows.size(), 5001u);
  for (const std::size_t row :
       {std::size_t{0}, std::size_t{2047}, std::size_t{2048}, std::size_t{4999}}) {
    const MeasuredBlock& block = report.populations[0].population.blocks[row];
    EXPECT_EQ(table.rows[row].at("block"), block.name);
    EXPECT_EQ(table.number(row, "L_m"), block.axes.L);
    EXPECT_EQ(table.number(row, "mass_kg"), *block.mass);
    EXPECT_EQ(table.rows[row].at("sneed_folk"), sneed_folk_class(block.axes));
    EXPECT_EQ(table.rows[row].at("shape"), garcia_class(block.axes));
    for (const auto& [name, value] : form_indices(block.axes)) {
      EXPECT_EQ(table.number(row, name), value) << name;
    }
  }
  EXPECT_EQ(table.rows[5000].at("disc_rod_index"), "");
  EXPECT_EQ(table.rows[5000].at("mass_kg"), "");
}

TEST(PopulationPage, EverySchemeHasItsDiagramAndColumn) {
  PopulationReport report = report_of({blocks("talus", 6)});
  report.options.schemes.clear();  // all
  report.options.limits.sneed_folk_thirds = true;
  report.populations[0].summary =
      summarise_population(report.populations[0].population, report.options);
  const PopulationDiagrams diagrams = draw_population_diagrams(report);
  const ScratchFolder folder;
  write_classes_csv(report, folder / "classes.csv");
  const CsvTable table = read_csv(read_text_file(folder / "classes.csv"));
  for (const std::string& scheme : scheme_names()) {
    const std::string& svg = diagrams.at("shares_" + class_column_name(scheme));
    for (const std::string& name : class_names(scheme))
      EXPECT_TRUE(contains(svg, escape_html(name)));
    const MeasuredBlock& block = report.populations[0].population.blocks[3];
    EXPECT_EQ(table.rows[3].at(class_column_name(scheme)),
              shape_class(scheme, block.axes, report.options.limits));
  }
  EXPECT_EQ(unbalanced(make_population_page(report, diagrams)), "");
}

// A block on the limit of C says so where its mark is.
TEST(PopulationPage, BlocksNearALimitSaySo) {
  Population population{"two",
                        {make_measured_block("edge", {1.0, 0.85, 0.7}),
                         make_measured_block("clear", {1.0, 0.9, 0.1})}};
  population.blocks[0].axis_error = 0.05;
  const std::string edge = format_block_tooltip(population.blocks[0], {.schemes = {"sneed-folk"}});
  EXPECT_TRUE(contains(edge, "sneed-folk: C (") && contains(edge, "0.7"));
  EXPECT_EQ(format_block_tooltip(population.blocks[1], {.schemes = {"zingg"}}).find('('),
            std::string::npos);
}

TEST(PopulationTables, SharesAndSizesAreThoseOfTheSummary) {
  const PopulationReport report = report_of({blocks("a", 30), blocks("b", 20, false)});
  const CsvTable shares = read_csv(find_report_table(population_tables(), "shares").csv(report));
  EXPECT_EQ(shares.rows.size(), 2u * (10 + 4 + 2));
  const ClassFraction& first = report.populations[0].summary.schemes[0].fractions[0];
  EXPECT_EQ(shares.number(0, "blocks"), double(first.count));
  EXPECT_EQ(shares.number(0, "mass_share_high"), first.mass_high);
  EXPECT_EQ(shares.rows[16].at("population"), "b");
  EXPECT_EQ(shares.rows[16].at("mass_share"), "");
  const CsvTable sizes = read_csv(find_report_table(population_tables(), "sizes").csv(report));
  const std::size_t d50 = sizes.find("quantity", "d50");
  EXPECT_EQ(sizes.number(d50, "value"), report.populations[0].summary.size.by_number.d50);
  EXPECT_EQ(sizes.rows[d50].at("unit"), "m");
  const std::size_t d63 = sizes.find("quantity", "rosin_rammler_d63");
  EXPECT_EQ(sizes.number(d63, "standard_error"),
            report.populations[0].summary.size.by_number.laws[1].location_error);
  const CsvTable tests = read_csv(find_report_table(population_tables(), "tests").csv(report));
  EXPECT_EQ(tests.rows.size(), 3u + 3u + 3u + 3u);
  EXPECT_EQ(tests.number(6, "statistic"), report.comparison->measures[0].test->statistic);
}

// Keys and columns are two formats (docs/architecture.md); what they say is the same.
TEST(PopulationTables, TheJsonHasTheFiguresOfTheTables) {
  const ScratchFolder folder;
  const PopulationReport report = report_of({blocks("a", 30)});
  std::ostringstream text;
  write_population_json(text, report);
  const auto json = nlohmann::json::parse(text.str());

  const CsvTable shares = read_csv(find_report_table(population_tables(), "shares").csv(report));
  std::size_t row = 0;
  for (const std::string& scheme : report.options.schemes) {
    for (const auto& share : json["population"][scheme]) {
      EXPECT_EQ(shares.rows[row].at("scheme"), scheme);
      EXPECT_EQ(shares.rows[row].at("class"), share["class"]);
      for (const auto& [column, key] :
           std::map<std::string, std::string>{{"blocks", "blocks"},
                                              {"share", "share"},
                                              {"share_low", "low"},
                                              {"share_high", "high"},
                                              {"mass_kg", "mass_kg"},
                                              {"mass_share", "mass_share"},
                                              {"mass_share_low", "mass_low"},
                                              {"mass_share_high", "mass_high"}}) {
        EXPECT_EQ(shares.number(row, column), share[key].get<double>()) << column;
      }
      ++row;
    }
  }
  EXPECT_EQ(row, shares.rows.size());

  write_classes_csv(report, folder / "classes.csv");
  const CsvTable classes = read_csv(read_text_file(folder / "classes.csv"));
  ASSERT_EQ(classes.rows.size(), json["blocks"].size());
  for (std::size_t i = 0; i < classes.rows.size(); ++i) {
    const auto& block = json["blocks"][i];
    EXPECT_EQ(classes.rows[i].at("block"), block["id"]);
    EXPECT_EQ(classes.number(i, "L_m"), block["box_m"][0].get<double>());
    EXPECT_EQ(classes.number(i, "S_m"), block["box_m"][2].get<double>());
    EXPECT_EQ(classes.number(i, "mass_kg"), block["mass_kg"].get<double>());
    for (const std::string& scheme : report.options.schemes) {
      EXPECT_EQ(classes.rows[i].at(class_column_name(scheme)), block["classes"][scheme]["class"]);
    }
    for (const auto& [name, value] : block["indices"].items()) {
      EXPECT_EQ(classes.number(i, name), value.get<double>()) << name;
    }
  }
}

TEST(PopulationReports, AreWrittenWhole) {
  const ScratchFolder folder;
  write_population_report(report_of({blocks("talus", 9)}), folder / "out");
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder / "out")) {
    names.insert(entry.path().filename());
  }
  EXPECT_EQ(names, (std::set<std::string>{
                       "report.html", "classes.csv", "shares.csv", "sizes.csv", "tests.csv",
                       "provenance.json", "sneed_folk.svg", "zingg.svg", "s_c.svg", "size.svg",
                       "shares_sneed_folk.svg", "shares_zingg.svg", "shares_shape.svg"}));
  EXPECT_TRUE(contains(read_text_file(folder / "out" / "provenance.json"), std::string(64, 'a')));
  write_text_file(folder / "file", "");
  EXPECT_TRUE(contains(
      refusal([&] { write_population_report(report_of({blocks("t", 2)}), folder / "file"); }),
      "is a file"));
}

// Everything that shaped the tables can be read from the file beside them.
TEST(PopulationReports, ProvenanceHoldsTheOptionsOfEveryPopulation) {
  const ScratchFolder folder;
  PopulationReport report = report_of({blocks("scans", 9), blocks("talus", 5)});
  report.options.limits.erdogan_limit = 1.4;
  report.populations[0].reading = {.box = "feret", .axis_error = 0.01};
  report.populations[1].reading = {.columns = "L=5,I=6,S=7", .units = "cm"};
  write_population_report(report, folder / "out");
  const auto json = nlohmann::json::parse(read_text_file(folder / "out" / "provenance.json"));
  EXPECT_EQ(json["options"]["erdogan_limit"], 1.4);
  const auto& scans = json["populations"][0];
  const auto& talus = json["populations"][1];
  EXPECT_EQ(scans["box"], "feret");
  EXPECT_EQ(scans["axis_error_m"], 0.01);
  EXPECT_TRUE(scans["columns"].is_null() && scans["units"].is_null());
  EXPECT_EQ(talus["columns"], "L=5,I=6,S=7");
  EXPECT_EQ(talus["units"], "cm");
  EXPECT_TRUE(talus["box"].is_null() && talus["axis_error_m"].is_null());
  EXPECT_EQ(talus["inputs"][0]["file"], "talus.csv");
  EXPECT_EQ(talus["inputs"][0]["sha256"], std::string(64, 'a'));
}

TEST(PopulationReports, DiagramsOfAnEarlierReportAreRemoved) {
  const ScratchFolder folder;
  const auto names = [&] {
    std::set<std::string> all;
    for (const auto& entry : std::filesystem::directory_iterator(folder / "out")) {
      all.insert(entry.path().filename());
    }
    return all;
  };
  const auto write = [&](const PopulationReport& report) {
    const std::filesystem::path target = folder / "out";
    OutputFolder whole(target, population_folder_kind(target), true);
    write_population_report(report, whole.temporary_path());
    whole.commit();
  };
  const PopulationReport one = report_of({blocks("talus", 9)});
  PopulationReport two = report_of({blocks("talus", 9), blocks("scree", 5)});
  // Files of the user's own stay, also one called as a diagram that clast did not write.
  write_text_file(folder / "out" / "size_1.svg", "mine");
  write_text_file(folder / "out" / "notes.svg", "mine");
  write(one);
  EXPECT_EQ(read_text_file(folder / "out" / "size_1.svg"), "mine");
  EXPECT_TRUE(contains(refusal([&] { write(two); }),
                       "size_1.svg: does not belong to the existing classific"));
  EXPECT_EQ(read_text_file(folder / "out" / "size_1.svg"), "mine");
  const std::set<std::string> of_one = names();
  std::filesystem::remove(folder / "out" / "size_1.svg");
  write(two);
  EXPECT_FALSE(names().count("size.svg") || names().count("zingg.svg"));
  EXPECT_TRUE(names().count("size_1.svg") && names().count("sizes.svg"));
  two.options.schemes = {"zingg"};
  for (ReportedPopulation& reported : two.populations) {
    reported.summary = summarise_population(reported.population, two.options);
  }
  write(two);
  EXPECT_FALSE(names().count("shares_shape.svg"));
  EXPECT_TRUE(names().count("shares_zingg.svg"));
  write(one);
  std::set<std::string> expected = of_one;
  expected.erase("size_1.svg");
  EXPECT_EQ(names(), expected);
}

TEST(LogTicks, AreRoundAndFew) {
  EXPECT_EQ(choose_log_ticks(0.09, 2.0, 9), (std::vector<double>{0.1, 0.2, 0.5, 1.0, 2.0}));
  EXPECT_EQ(choose_log_ticks(0.001, 1000.0, 9).size(), 7u);
}

// 1.3/1.0 - 1 is a hair above 0.3 in binary and compact all the same: its bar ends at the limit.
TEST(Histogram, AValueOnALimitIsBelowIt) {
  for (const double highest : {0.5, 0.9, 2.0, 4.0}) {
    for (const double lowest : {0.0, 0.3}) {
      ChartSeries series{"talus", "#000000", "", {lowest, 1.3 / 1.0 - 1.0, 0.301, highest}};
      series.names = {"low", "edge", "over", "high"};
      const std::string svg = draw_histogram({"s_c", "s_c", false, {{0.3, "limit"}}}, {series});
      const double limit = number_after(svg, "stroke-dasharray", " x1=\"");
      const auto bar = [&](const std::string& name) {
        const std::size_t rect = svg.rfind("<rect", svg.find("\n" + name));
        const std::string element = svg.substr(rect, svg.find("/rect>", rect) - rect);
        const double x = number_after(element, " x=\"", " x=\"");
        return std::pair(x, x + number_after(element, " width=\"", " width=\""));
      };
      EXPECT_LE(bar("edge").second, limit + 0.1) << highest << " " << lowest;
      EXPECT_GE(bar("over").first, limit - 0.1) << highest << " " << lowest;
      EXPECT_GE(bar("low").first, 56.0);  // left end of the axis
      EXPECT_LE(bar("high").second, 508.5);
    }
  }
}

// What is drawn stays in the picture, however long the names are.
TEST(PopulationPage, LongNamesStayInThePictures) {
  const std::string name = "Ch\xc3\xa2teau " + std::string(150, 'n');
  const PopulationReport report = report_of({blocks(name + "1", 9), blocks(name + "2", 9)});
  for (const auto& [file, svg] : draw_population_diagrams(report)) {
    for (std::size_t at = svg.find("<text "); at != std::string::npos;
         at = svg.find("<text ", at + 1)) {
      const std::size_t begin = svg.find('>', at) + 1;
      EXPECT_LT(svg.find('<', begin) - begin, 80u) << file << svg.substr(begin, 200);
    }
    EXPECT_TRUE(is_utf8(svg)) << file;
  }
  const std::string shares =
      draw_class_fractions("t", {"C"},
                           {{std::string(60, 'a'), "#000000", {{0.5, 0.4, 0.6, ""}}},
                            {std::string(60, 'b'), "#000000", {{0.5, 0.4, 0.6, ""}}}});
  // Two names and the whiskers, a row each, inside the height.
  const double a = number_after(shares, "aaaa</text>", " y=\"");
  const double b = number_after(shares, "bbbb</text>", " y=\"");
  const double whiskers = number_after(shares, ">whiskers", " y=\"");
  EXPECT_LT(a, b);
  EXPECT_LT(b, whiskers);
  EXPECT_LT(whiskers, std::strtod(shares.c_str() + shares.find("0 0 520 ") + 8, nullptr));
}

TEST(Html, ShortenedTextKeepsItsCharactersWhole) {
  EXPECT_EQ(shorten_text("talus", 5), "talus");
  EXPECT_EQ(shorten_text("taluses", 5), "talu\xe2\x80\xa6");
  EXPECT_EQ(shorten_text("\xc3\xa9\xc3\xa9\xc3\xa9", 3), "\xc3\xa9\xc3\xa9\xc3\xa9");
  EXPECT_EQ(shorten_text("\xc3\xa9\xc3\xa9\xc3\xa9", 2), "\xc3\xa9\xe2\x80\xa6");
}

// Half of the mass lies up to 2 m: the step to 50 % stands where the axis has 2 m.
TEST(CumulativeChart, WeighsItsValues) {
  ChartSeries series{"by mass", "#000000", "", {1.0, 2.0, 4.0}};
  series.weights = {10.0, 40.0, 50.0};
  series.names = {"a", "b", "c"};
  const std::string svg = draw_cumulative_chart({"Size", "size, m", true}, {series});
  EXPECT_TRUE(contains(svg, "b\n50.0 % up to here, by mass"));
  const double x1 = number_after(svg, "a\n10.0 %", " cx=\"");
  EXPECT_EQ(unbalanced(svg), "");
  EXPECT_GT(x1, 0.0);
}

}  // namespace
}  // namespace clast
