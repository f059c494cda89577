#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "core/error.hpp"
#include "core/files/text_file.hpp"
#include "core/random.hpp"
#include "report/charts/plotly_chart.hpp"
#include "report/charts/ticks.hpp"
#include "report/html/html_page.hpp"
#include "report/html/page_script.hpp"
#include "report/maps/map_style.hpp"
#include "report/pages/comparison_page.hpp"
#include "report/pages/report_sections.hpp"
#include "report/text/key_results_text.hpp"
#include "study/compare/path_rasters.hpp"
#include "terrain/relief.hpp"
#include "tests/study/hand_made_results.hpp"
#include "tests/study/made_up_runs.hpp"
#include "tests/support/markup.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/scratch_folder.hpp"

namespace clast {
namespace {

using namespace report_detail;

std::string comparison_report(const Comparison& comparison) {
  return make_comparison_page(comparison);
}

TEST(HtmlReport, TagsAreBalanced) {
  EXPECT_EQ(unbalanced(comparison_report(compared(hand_made_results()))), "");
  EXPECT_NE(unbalanced("<p><b>x</p></b>"), "");
  EXPECT_NE(unbalanced("<p>"), "");
}

TEST(HtmlReport, NamesEveryBlockWithItsCharactersEscaped) {
  const std::string html = comparison_report(compared(hand_made_results()));
  EXPECT_TRUE(contains(html, "round&lt;1&gt;"));
  EXPECT_TRUE(contains(html, "long, &quot;2&quot;"));
  EXPECT_TRUE(contains(html, "B&lt;1&gt;"));
  EXPECT_FALSE(contains(html, "round<1>"));
  EXPECT_FALSE(contains(html, "B<1>"));
  EXPECT_TRUE(contains(html, "# a &lt; b &amp; c"));
}

TEST(HtmlReport, ListsTheStiffnessOfEveryBlock) {
  const Comparison comparison = compared(hand_made_results());
  const std::string section = format_provenance_section(comparison);
  for (const char* part : {"k_n, N/m", "k_r, N m/rad", "time step, s", "1e+08", "3e+08 to 4e+08",
                           "1e-05", "2e-05", "0.012", "0.016"}) {
    EXPECT_TRUE(contains(section, part)) << part;
  }
  EXPECT_TRUE(contains(section, "k_n 1e+08 to 4e+08 N/m, step 1e-05 to 2e-05 s"));
}

TEST(HtmlReport, SaysWhatWasRun) {
  const std::string html = comparison_report(compared(hand_made_results()));
  for (const std::string& part : {std::string(64, 'a'), std::string(64, 'b'), std::string(64, 'c'),
                                  std::string("hand-made.h5"), std::string("clast 0.1.0")}) {
    EXPECT_TRUE(contains(html, part)) << part;
  }
}

// Three draws of the ground are not three times as many orientations, and no run had their middle.
TEST(HtmlReport, AnEnsembleIsNeitherMoreOrientationsNorFixedParameters) {
  CampaignResults results = hand_made_results();
  results.planned_runs = 6;
  for (std::uint32_t member = 0; member < 3; ++member) {
    results.ground_sets.push_back(
        {"", member, {{0.01, 0.5 + 0.1 * member, 0.35}, {0.01, 0.3, 0.0}}});
    results.runs[member].ground_set = member;
    results.runs[member + 3].ground_set = member;
  }
  const Comparison comparison = compared(std::move(results));
  const std::string html = comparison_report(comparison);
  EXPECT_TRUE(contains(html, "1 orientation \xC3\x97 3 draws of the ground"));
  EXPECT_TRUE(contains(html, "0.500 to 0.700"));
  EXPECT_TRUE(contains(format_ensemble_section(comparison),
                       "Over 3 draws of the ground parameters, the mean runout is"));
  EXPECT_TRUE(contains(describe_key_results(comparison, summarise_key_results(comparison)).front(),
                       "Over 3 draws of the ground, mean runout is"));
}

TEST(HtmlReport, RefersToNothingOutsideItself) {
  // What plotly.js says of itself in comments is not looked at: another one stands in for it.
  const ScratchFolder folder;
  write_text_file(folder / "plotly.js", "var Plotly={};");
  ASSERT_EQ(::setenv("CLAST_PLOTLY", folder.path().c_str(), 1), 0);
  std::string html = comparison_report(compared(hand_made_results()));
  ::unsetenv("CLAST_PLOTLY");
  EXPECT_TRUE(contains(html, format_packed_element("plotly-code", "var Plotly={};")));
  // The relief is data, too.
  const std::string picture = "data:image/png;base64,";
  EXPECT_EQ(count_of(html, picture), 1u);
  expect_self_contained(html);
}

TEST(HtmlReport, ShowsWarningsAndLostRunsWithTheirReason) {
  CampaignResults results = hand_made_results();
  results.runs[2].result.stop_reason = StopReason::kError;
  results.runs[2].result.message = "turned to <nan> in step 7";
  results.runs[2].result.final_state.position = Vec3::Constant(NAN);
  const std::string html = comparison_report(compared(std::move(results)));
  EXPECT_EQ(unbalanced(html), "");
  EXPECT_TRUE(contains(html, "mass differs between classes"));
  EXPECT_TRUE(contains(html, "1 of 6 runs failed with an error."));
  EXPECT_TRUE(contains(html, "turned to &lt;nan&gt; in step 7"));
  EXPECT_FALSE(contains(html, "=\"nan\""));
}

TEST(HtmlReport, StandsRunsThatAllFailed) {
  CampaignResults results = hand_made_results();
  results.crossings.clear();
  for (RunRecord& run : results.runs) {
    run.result = ReleaseResult();
    run.result.final_state.position = Vec3::Constant(NAN);
  }
  EXPECT_EQ(unbalanced(comparison_report(compared(std::move(results)))), "");
}

TEST(HtmlReport, StandsOneRunWithoutBarriersOrTerrain) {
  CampaignResults results = hand_made_results();
  results.runs.resize(1);
  results.crossings.clear();
  results.barriers.clear();
  results.terrain = Terrain();
  results.terrain.frame = results.frame;
  EXPECT_EQ(unbalanced(comparison_report(compared(std::move(results)))), "");
}

using Json = nlohmann::json;

/// What the page's charts draw, by their labels.
std::map<std::string, Json> figures_of(const std::string& html) {
  std::map<std::string, Json> figures;
  const std::string label = "aria-label=\"", open = "class=\"chart-data\">";
  for (std::size_t at = html.find("<div class=\"chart "); at != std::string::npos;
       at = html.find("<div class=\"chart ", at + 1)) {
    const std::size_t name = html.find(label, at) + label.size();
    const std::size_t begin = html.find(open, at) + open.size();
    const std::string json = html.substr(begin, html.find("</script>", begin) - begin);
    figures[html.substr(name, html.find('"', name) - name)] = Json::parse(json);
  }
  return figures;
}

const Json& trace_named(const Json& figure, const std::string& name) {
  for (const Json& trace : figure.at("data")) {
    if (trace.at("name") == name) return trace;
  }
  throw std::runtime_error("no trace " + name + " in " + figure.at("data").dump().substr(0, 400));
}

TEST(ReportMap, MarksEveryStopUntilThereAreTooMany) {
  const auto few = figures_of(format_map_section(compared(hand_made_results()), {}, {}));
  const Json& map = few.at("map of stops, release points and barriers");
  const Json& stops = trace_named(map, "long, &quot;2&quot; (elongated)");
  ASSERT_EQ(stops["x"].size(), 2u);
  EXPECT_EQ(stops["x"][0], kMapOrigin.x() + 10.0);
  EXPECT_EQ(stops["y"][0], kMapOrigin.y() - 10.0);
  EXPECT_TRUE(contains(stops["text"][0], "run 4, block long, &quot;2&quot;, point 0, orient"));
  EXPECT_EQ(trace_named(map, "release point")["x"].size(), 1u);
  // B<1> runs from y = -20 to 20 m at x = 10 m, so forward is +x; pixels count y down.
  const Json& arrow = map["layout"]["annotations"][0];
  EXPECT_EQ(arrow["text"], "<b>B&lt;1&gt;</b>");
  EXPECT_LT(double(arrow["ax"]), 0.0) << "it points from the tail at ax to the barrier";
  EXPECT_NEAR(double(arrow["ay"]), 0.0, 1e-9);

  CampaignResults many = hand_made_results();
  Random random(1);
  while (many.runs.size() <= kMaxSingleStops) {
    const auto run = static_cast<std::uint32_t>(many.runs.size());
    many.runs.push_back(
        hand_made_run(run, run % 2, random.uniform(5.0, 45.0), random.uniform(-15.0, 15.0)));
  }
  const std::size_t runs = many.runs.size();
  const auto crowded = figures_of(format_map_section(compared(std::move(many)), {}, {}));
  const Json& density =
      trace_named(crowded.at("map of stops, release points and barriers"), "stops");
  std::size_t counted = 0;
  for (const Json& row : density["customdata"]) {
    for (const Json& cell : row) counted += cell.is_null() ? 0 : std::size_t(cell);
  }
  EXPECT_EQ(counted, runs) << "every stop is in one square";
}

TEST(ReportCharts, HoldTheSharesOfEveryClass) {
  const auto figures = figures_of(comparison_report(compared(hand_made_results())));
  // Compact blocks stop at 10, 20, 30 and 40 m, elongated ones at 10 and 20 m.
  const Json& stops = trace_named(
      figures.at("Fraction of runs that stop before a runout, by class"), "compact (4)");
  EXPECT_EQ(stops["x"], Json::parse("[10.0,10.0,20.0,30.0,40.0]"));
  EXPECT_EQ(stops["y"], Json::parse("[0.0,0.25,0.5,0.75,1.0]"));
  const Json& bars = trace_named(figures.at("Runout by class"), "elongated (2)");
  double sum = 0.0;
  for (const Json& share : bars["y"]) sum += double(share);
  EXPECT_NEAR(sum, 1.0, 1e-12);
  // First crossings of B<1> have speeds 2, 4 and 6 m/s (compact) and 3 m/s: 150 v^2 + 50 J.
  const Json& energy =
      trace_named(figures.at("B&lt;1&gt;: crossings above an energy"), "elongated (1)");
  EXPECT_EQ(energy["x"], Json::parse("[1.4]"));
  EXPECT_EQ(energy["y"], Json::parse("[1.0]"));
  EXPECT_EQ(energy["mode"], "markers") << "too few for a curve";
}

// Two blocks say nothing of what share goes with the block: the numbers are folded away.
TEST(HtmlReport, SharesOfFewBlocksAreFolded) {
  const std::string page = comparison_report(compared(made_up_results()));
  const std::size_t said = page.find("There are too few blocks to estimate");
  ASSERT_NE(said, page.npos);
  EXPECT_LT(said, page.find("<summary>Fractions of the variance</summary>"));
}

TEST(ReportCharts, LargeSamplesAreThinnedToTheirEnds) {
  ChartSeries sample{"many", "#000000", "", {}};
  for (int i = 0; i < 100'000; ++i) sample.values.push_back(i);
  const std::vector<ChartTrace> traces = make_cumulative_traces({sample});
  ASSERT_EQ(traces.size(), 1u);
  EXPECT_LT(traces[0].x.size(), 2000u);
  EXPECT_EQ(traces[0].x.front(), 0.0);
  EXPECT_EQ(traces[0].x.back(), 99'999.0);
  EXPECT_EQ(traces[0].y.back(), 1.0);
  for (std::size_t i = 1; i + 1 < traces[0].x.size(); ++i) {
    EXPECT_NEAR(traces[0].y[i], (traces[0].x[i] + 1.0) / 100'000.0, 1e-12);
  }
}

TEST(ReportCharts, SayWhatIsMissingWhereTheLibraryIs) {
  const ScratchFolder folder;
  ASSERT_EQ(::setenv("CLAST_PLOTLY", folder.path().c_str(), 1), 0);
  const std::string html = comparison_report(compared(hand_made_results()));
  ::unsetenv("CLAST_PLOTLY");
  EXPECT_TRUE(contains(html, "apt install python3-plotly"));
  EXPECT_TRUE(contains(html, (folder / "plotly.js").string()));
  EXPECT_TRUE(figures_of(html).empty());
  EXPECT_TRUE(contains(html, "runout mean")) << "tables are there all the same";
  EXPECT_EQ(unbalanced(html), "");
}

TEST(HtmlPage, LinksKeepOddNames) {
  EXPECT_EQ(format_link_target("blocks/B 1 #2?.html"), "blocks/B%201%20%232%3F.html");
  EXPECT_EQ(format_link_target("\xC3\xA9"), "%C3%A9");
}

TEST(Base64, EncodesTheVectorsOfRfc4648) {
  EXPECT_EQ(encode_base64(""), "");
  EXPECT_EQ(encode_base64("f"), "Zg==");
  EXPECT_EQ(encode_base64("fo"), "Zm8=");
  EXPECT_EQ(encode_base64("foo"), "Zm9v");
  EXPECT_EQ(encode_base64("foob"), "Zm9vYg==");
  EXPECT_EQ(encode_base64("fooba"), "Zm9vYmE=");
  EXPECT_EQ(encode_base64("foobar"), "Zm9vYmFy");
  EXPECT_EQ(encode_base64("\xFF\xFE\xFD"), "//79");
}

TEST(Relief, SamplesThePlaneAtCellCentres) {
  const CampaignResults results = hand_made_results();
  const PlanWindow window{Vec2(-20.0, -25.0), Vec2(60.0, 15.0)};
  const Relief relief = sample_relief(results.terrain, window, 80);
  ASSERT_EQ(relief.columns, 80u);
  ASSERT_EQ(relief.rows, 40u);
  for (std::uint32_t row = 0; row < relief.rows; ++row) {
    for (std::uint32_t column = 0; column < relief.columns; ++column) {
      const double x = -19.5 + column, height = relief.height[row * 80 + column];
      if (x < -10.0) {
        EXPECT_TRUE(std::isnan(height));
      } else {
        EXPECT_NEAR(height, -0.5 * x, 1e-12);
        EXPECT_EQ(relief.zone[row * 80 + column], x < 20.0 ? 0 : 1);
      }
    }
  }
}

TEST(Relief, ShowsTheUpperOfTwoSurfaces) {
  Terrain terrain;
  for (const double z : {5.0, 1.0}) {
    for (const Vec2& corner : {Vec2(0, 0), Vec2(4, 0), Vec2(0, 4)}) {
      terrain.surface.vertices.push_back({corner.x(), corner.y(), z});
    }
  }
  terrain.surface.triangles = {{0, 1, 2}, {3, 4, 5}};
  terrain.zone = {1, 0};
  const Relief relief = sample_relief(terrain, {Vec2(0, 0), Vec2(4, 4)}, 4);
  const std::size_t corner = 3 * 4;  // lower left
  EXPECT_EQ(relief.height[corner], 5.0);
  EXPECT_EQ(relief.zone[corner], 1);
}

TEST(AxisTicks, AreRoundAndInside) {
  const AxisTicks marks = choose_ticks(-3.2, 47.9, 7);
  EXPECT_EQ(marks.step, 10.0);
  EXPECT_EQ(marks.values, (std::vector<double>{0.0, 10.0, 20.0, 30.0, 40.0}));
  EXPECT_EQ(choose_ticks(0.0, 0.5, 5).decimals, 1);
  EXPECT_EQ(choose_ticks(6500000.0, 6500100.0, 5).values.front(), 6500000.0);
}

TEST(AxisTicks, EndOnRangesThatHaveNoWidth) {
  EXPECT_EQ(choose_ticks(3.0, 3.0, 5).values.size(), 1u);
  EXPECT_EQ(choose_ticks(1e9, std::nextafter(1e9, 2e9), 5).values.size(), 1u);
  EXPECT_EQ(choose_ticks(0.0, INFINITY, 5).values.size(), 1u);
}

TEST(PageNumbers, AreWrittenAsAReaderExpects) {
  EXPECT_EQ(format_fixed(-0.04, 1), "0.0");
  EXPECT_EQ(format_fixed(NAN, 1), "-");
  EXPECT_EQ(format_significant_digits(1474.68, 4), "1475");
  EXPECT_EQ(format_significant_digits(0.012345, 3), "0.0123");
  EXPECT_EQ(format_significant_digits(9.996, 3), "10.0");
  EXPECT_EQ(format_significant_digits(8.7e7, 3), "8.70e+07");
  EXPECT_EQ(format_percent(0.03125), "3.1 %");
  EXPECT_EQ(escape_html("a<b & \"c\">'\x01"), "a&lt;b &amp; &quot;c&quot;&gt;&#39;");
}

TEST(ZoneTint, FollowsTheNameWhenItIsAColour) {
  EXPECT_EQ(zone_colour("Blue", 3), zone_colour("blue", 0));
  EXPECT_NE(zone_colour("blue", 0), zone_colour("red", 0));
  EXPECT_NE(zone_colour("scree", 0), zone_colour("rock", 1));
}

}  // namespace
}  // namespace clast
