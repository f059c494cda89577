// The first screen in words, for every kind of campaign.
#include "report/text/key_results_text.hpp"
#include "report/text/key_figures.hpp"
#include "report/text/measured_text.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "core/files/text_file.hpp"
#include "core/number_text.hpp"
#include "report/pages/report_sections.hpp"
#include "report/text/plain_numbers.hpp"
#include "study/results/block_scale.hpp"
#include "tests/study/made_up_runs.hpp"
#include "tests/support/markup.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/scratch_folder.hpp"

namespace clast {
namespace {

using namespace report_detail;

std::string sentences(const Comparison& comparison) {
  std::string text;
  for (const std::string& sentence :
       describe_key_results(comparison, summarise_key_results(comparison))) {
    text += sentence + "\n";
  }
  return text;
}

std::string sentences(CampaignResults results) { return sentences(compared(std::move(results))); }

TEST(PlainNumbers, HaveTheDigitsThatAreKnown) {
  EXPECT_EQ(decimals_of_length(13.2, Interval{10.0, 17.0}), 0);
  EXPECT_EQ(decimals_of_length(13.2, Interval{13.0, 14.0}), 1);
  EXPECT_EQ(decimals_of_length(1.32, Interval{1.25, 1.4}), 2);
  EXPECT_EQ(decimals_of_length(130.0), 0);
  EXPECT_EQ(format_length_interval({-1.2, 5.4}, 0), "-1 to 5 m");
  EXPECT_EQ(format_percentage(0.34), "34 %");
  EXPECT_EQ(format_percentage(0.0), "0 %");
  EXPECT_EQ(format_percentage(0.004), "0.4 %");
  EXPECT_EQ(format_percentage(0.997), "99.7 %") << "nearly all is not all";
  EXPECT_EQ(format_percentage_interval({0.004, 0.051}), "0.4 to 5 %");
  EXPECT_EQ(format_energy(1'075'300.0), "1075 kJ");
  EXPECT_EQ(format_energy(43'200.0), "43 kJ");
  EXPECT_EQ(format_energy(4320.0), "4.3 kJ");
  EXPECT_EQ(format_energy(432.0), "432 J");
  EXPECT_EQ(format_height(1.04), "1.0 m");
  EXPECT_EQ(format_height(0.354), "0.35 m");
  EXPECT_EQ(format_energy_limit(33'400.0), "34 kJ") << "no load is rounded down";
  EXPECT_EQ(format_energy_limit(33'000.0), "33 kJ");
  EXPECT_EQ(format_energy_limit(4310.0), "4.4 kJ");
  EXPECT_EQ(format_energy_limit(431.2), "432 J");
  EXPECT_EQ(format_height_limit(1.04), "1.1 m");
  EXPECT_EQ(format_height_limit(0.354), "0.36 m");
  EXPECT_EQ(format_speed_limit(10.11), "10.2 m/s");
}

TEST(AnswerText, SaysWhichClassRunsFartherAndWhoPasses) {
  CampaignResults results = made_up_results();
  add_barrier(results, "EC22", 38.0);
  const Comparison comparison = compared(std::move(results));
  const FileSummary statement = summarise_key_results(comparison).file_summaries.at(0);
  const RunoutContrast& gap = *statement.class_contrast;
  const BarrierSummary& passage = statement.passages.at(0);
  const int decimals = decimals_of_length(gap.mean_difference, gap.interval);
  EXPECT_EQ(sentences(comparison),
            "Compact blocks run " + format_length(gap.mean_difference, decimals) +
                " farther than elongated ones (" + format_length_interval(*gap.interval, decimals) +
                ", for runs of these 2 blocks only). " +
                format_percentage(passage.classes[0].passing_probability) + " of compact and " +
                format_percentage(passage.classes[1].passing_probability) +
                " of elongated blocks pass EC22. Of the blocks that pass, 95 % carry less than " +
                format_energy_limit(passage.all.energy) + ", and the tops of 95 % stay below " +
                format_height_limit(passage.all.top) + ".\n");
}

TEST(AnswerText, SaysWhenItCanBeChance) {
  const std::string text =
      sentences(made_up_results({.compact = 30.0, .elongated = 30.0, .seed = 4}));
  EXPECT_TRUE(contains(text, "blocks run "));
  EXPECT_TRUE(contains(text, "is not significant"));
  EXPECT_FALSE(contains(text, "farther"));
}

TEST(AnswerText, OneClassHasADistanceInsteadOfADifference) {
  const std::string text = sentences(made_up_results({.elongated = NAN}));
  EXPECT_TRUE(text.starts_with("Block round<1> runs ")) << text;
  EXPECT_TRUE(contains(text, " m on average ("));
  EXPECT_TRUE(contains(text, "95 % stop before "));
  EXPECT_FALSE(contains(text, "elongated"));
}

TEST(AnswerText, AFewRunsHaveALargestValueOnly) {
  const std::string text =
      sentences(made_up_results({.elongated = NAN, .points = 1, .runs_each = 5}));
  EXPECT_TRUE(contains(text, ", at most "));
  EXPECT_FALSE(contains(text, "95 % stop"));
}

TEST(AnswerText, RunsThatEndEarlyAreSaid) {
  CampaignResults some = made_up_results();
  for (RunRecord& run : some.runs) {
    if (run.run % 10 == 0) run.result.stop_reason = StopReason::kLeftTerrain;
  }
  EXPECT_TRUE(contains(sentences(std::move(some)),
                       "Among the 90 % of runs that came to rest, compact blocks run "));
  CampaignResults all = made_up_results();
  for (RunRecord& run : all.runs) run.result.stop_reason = StopReason::kLeftTerrain;
  EXPECT_TRUE(contains(sentences(all),
                       "Runouts cannot be compared: 0 of 96 compact and 0 of 96 elongated "
                       "blocks came to rest (192 left the surveyed terrain)."));
  std::erase_if(all.runs, [](const RunRecord& run) { return run.block == 1; });
  EXPECT_TRUE(contains(
      sentences(std::move(all)),
      "No run of 96 came to rest (96 left the surveyed terrain), so the runout is not known."));
}

TEST(AnswerText, OneRealisationIsNotEvidence) {
  CampaignResults results = made_up_results();
  add_barrier(results, "foot", 30.0);
  let_stay(results, 1);
  const Comparison comparison = compared(std::move(results));
  EXPECT_TRUE(
      contains(sentences(comparison), "; with one realisation, significance cannot be tested."));
  EXPECT_FALSE(contains(sentences(comparison), "farther"));
  EXPECT_TRUE(contains(describe_intervals(summarise_key_results(comparison)),
                       "With one realisation, no interval"));
  for (const KeyFigure& figure :
       select_key_figures(comparison, summarise_key_results(comparison))) {
    EXPECT_EQ(figure.range, "") << figure.label;
  }
}

// Whatever is asked of one realisation: no page, table or text gives an interval or a p.
TEST(AnswerText, OneRealisationHasNoIntervalOnItsPage) {
  CampaignResults results = made_up_results({.compact = 60.0});
  add_barrier(results, "foot", 30.0);
  let_stay(results, 1);
  const Comparison comparison = compared(std::move(results));
  const std::string differences = format_differences_section(comparison);
  EXPECT_FALSE(contains(differences, "significant differences:"));
  EXPECT_FALSE(contains(differences, "No significant difference"));
  EXPECT_TRUE(contains(differences, "of one realisation, which can&#39;t tell what is chance:") ||
              contains(differences, "from one realisation, without a test:"))
      << differences.substr(0, 800);
  EXPECT_FALSE(contains(differences, "95 % interval</"));
  for (const BarrierGroupStatistics& group : comparison.barriers) EXPECT_FALSE(group.interval);
  EXPECT_FALSE(contains(format_barrier_section(comparison), "\xE2\x80\x93"));
}

TEST(AnswerText, UncertainGroundIsInTheTiles) {
  CampaignResults results = made_up_results({.runs_each = 20});
  draw_ground(results, 5, 3.0);
  add_barrier(results, "road", 30.0);
  const Comparison comparison = compared(std::move(results));
  const KeyResults found = summarise_key_results(comparison);
  const std::vector<KeyFigure> figures = select_key_figures(comparison, found);
  ASSERT_EQ(figures.size(), 4u);
  for (const KeyFigure& figure : figures) {
    EXPECT_TRUE(contains(figure.range, " over draws of the ground parameters")) << figure.label;
  }
  const CrossingEstimate& all = found.file_summaries[0].passages[0].all;
  EXPECT_EQ(figures[2].range, format_energy_limit(all.energy_range->low) + " to " +
                                  format_energy_limit(all.energy_range->high) +
                                  " over draws of the ground parameters");
  const std::string text = sentences(comparison);
  EXPECT_TRUE(
      contains(text, " over draws of the ground parameters, for runs of these 2 blocks only)."))
      << text;
  EXPECT_TRUE(contains(text, "Over 5 draws of the ground, mean runout is ")) << text;
  EXPECT_FALSE(contains(text, "nine draws in ten"));
  EXPECT_TRUE(
      contains(describe_intervals(found),
               "cover all draws; these ranges do not cover other release points or blocks."));
  EXPECT_FALSE(contains(describe_intervals(found), "95 %"));
}

// Most runs of both classes stop at the same place, a quarter of one class runs on.
TEST(AnswerText, DifferenceMadeByFewIsCalledSo) {
  CampaignResults results = made_up_results({.compact = 30.0, .elongated = 30.0, .seed = 4});
  for (RunRecord& run : results.runs) {
    if (run.block == 0 && run.run % 4 == 0) run.result.final_state.position.x() += 60.0;
  }
  const Comparison comparison = compared(std::move(results));
  EXPECT_TRUE(
      summarise_key_results(comparison).file_summaries.at(0).class_contrast->due_to_few_runs);
  EXPECT_TRUE(contains(sentences(comparison), " farther than elongated ones on average ("));
  EXPECT_TRUE(
      contains(sentences(comparison),
               ": the means differ because more of the compact blocks run far beyond the median"));
  EXPECT_FALSE(summarise_key_results(compared(made_up_results()))
                   .file_summaries.at(0)
                   .class_contrast->due_to_few_runs);
}

TEST(AnswerText, LargeNumbersSayWhatClassesAndTheLargestAre) {
  CampaignResults results = made_up_results();
  add_barrier(results, "road", 30.0);
  const Comparison comparison = compared(std::move(results));
  const KeyResults said = summarise_key_results(comparison);
  const std::vector<KeyFigure> figures = select_key_figures(comparison, said);
  ASSERT_EQ(figures.size(), 4u);
  const RunoutEstimate& compact = said.file_summaries[0].classes[0];
  EXPECT_TRUE(figures[0].more.starts_with("half stop before " + format_decimals(compact.median, 0)))
      << figures[0].more;
  const BarrierSummary& road = said.file_summaries[0].passages[0];
  EXPECT_EQ(figures[2].more, "compact " + format_energy_limit(road.classes[0].energy) +
                                 ", elongated " + format_energy_limit(road.classes[1].energy) +
                                 "; largest " + format_energy(road.all.largest_energy));
  EXPECT_TRUE(figures[1].more.starts_with(std::to_string(road.all.crossed) + " of 192 runs; "))
      << figures[1].more;
  EXPECT_TRUE(contains(figures[3].label, "top of the blocks at the road")) << figures[3].label;
  EXPECT_GT(road.all.top, road.all.height);
  EXPECT_GE(road.all.largest_energy, road.all.energy);
}

TEST(AnswerText, NamesThatAreNounsHaveAnArticle) {
  for (const auto& [name, said] :
       std::map<std::string, std::string>{{"road", "pass the road"},
                                          {"the road", "pass the road"},
                                          {"EC22", "pass EC22"},
                                          {"Fence 2", "pass Fence 2"},
                                          {"haul road", "pass the haul road"}}) {
    CampaignResults results = made_up_results();
    add_barrier(results, name, 1.0);
    EXPECT_TRUE(contains(sentences(std::move(results)), said + " (")) << name;
  }
}

TEST(AnswerText, SaysWhatWasNotRun) {
  const auto limits = [](CampaignResults results) {
    const Comparison comparison = compared(std::move(results));
    return describe_validity_limits(comparison, summarise_key_results(comparison));
  };
  EXPECT_EQ(limits(made_up_results({.points = 1, .runs_each = 12})),
            "Not run: blocks above 300 kg, other ground, other release points.");
  EXPECT_EQ(limits(made_up_results()), "Not run: blocks above 300 kg, other ground.");
}

TEST(AnswerText, NobodyPassesIsNotNever) {
  CampaignResults results = made_up_results();
  add_barrier(results, "road", 500.0);
  EXPECT_TRUE(contains(sentences(std::move(results)),
                       "None of 192 runs passes the road (the 95 % interval reaches 2 %)."));
}

TEST(AnswerText, EverybodyPassesIsSaidOnce) {
  CampaignResults results = made_up_results();
  add_barrier(results, "road", 1.0);
  EXPECT_TRUE(contains(sentences(std::move(results)),
                       "All 192 runs pass the road (98 to 100 %). Of the blocks"));
}

TEST(AnswerText, FewPassagesAreCountedNotRanked) {
  CampaignResults results = made_up_results({.points = 1, .runs_each = 12});
  double farthest = 0.0;
  for (const RunRecord& run : results.runs) {
    farthest = std::max(farthest, run.result.final_state.position.x());
  }
  add_barrier(results, "road", farthest - 0.5);
  const std::string text = sentences(std::move(results));
  EXPECT_TRUE(
      contains(text,
               "8 % of compact and 0 % of elongated blocks pass the road, with 500 J and its "
               "top at most 0.79 m above the ground."))
      << text;
}

TEST(AnswerText, RingsAreReached) {
  CampaignResults results = made_up_results();
  results.barriers = {
      {"house", {Vec2(38, -9), Vec2(60, -9), Vec2(60, 9), Vec2(38, 9), Vec2(38, -9)}}};
  results.crossings = {hand_made_crossing(0, 0, 1.0, 2.0)};
  results.crossings[0].forward = false;  // into a ring that runs counter-clockwise
  const std::string text = sentences(std::move(results));
  EXPECT_TRUE(
      contains(text,
               "elongated blocks reach the house, with 650 J and its top at most 1.8 m above the "
               "ground."))
      << text;
  EXPECT_FALSE(contains(text, "(in)"));
  EXPECT_FALSE(contains(text, "(out)"));
}

TEST(AnswerText, EveryFileHasItsSentence) {
  CampaignResults first = made_up_results(),
                  second = made_up_results({.compact = 80.0, .elongated = 60.0, .seed = 3});
  first.file = "hard.h5";
  second.file = "soft.h5";
  const Comparison comparison = compared(std::move(first), std::move(second));
  const std::string text = sentences(comparison);
  EXPECT_TRUE(contains(text, "File 1 (hard): compact blocks run "));
  EXPECT_TRUE(contains(text, "File 2 (soft): compact blocks run "));
  EXPECT_TRUE(contains(text, " farther in file 2 (soft) than in file 1 (hard) ("));
  EXPECT_LE(select_key_figures(comparison, summarise_key_results(comparison)).size(), 4u);
}

TEST(AnswerText, MeasuredStopsHaveAVerdict) {
  const auto verdict = [](double shift, std::size_t stops) {
    const ScratchFolder folder;
    Random random(3);
    std::string table = "x,y\n";
    for (std::size_t i = 0; i < stops; ++i) {
      table += std::to_string(kMapOrigin.x() + 40.0 + shift + 5.0 * random.normal()) + "," +
               std::to_string(kMapOrigin.y()) + "\n";
    }
    write_text_file(folder / "seen.csv", table);
    std::vector<CampaignResults> all;
    all.push_back(made_up_results({.elongated = NAN}));
    const Comparison comparison =
        compare(std::move(all), {.by = {}, .measured = folder / "seen.csv", .margin = {}});
    const std::string html = format_measured_section(comparison);
    EXPECT_EQ(unbalanced(html), "");
    return describe_measured_stops(comparison).at(0);
  };
  EXPECT_TRUE(contains(verdict(0.0, 30),
                       "All blocks: no significant difference between field and simulation"));
  EXPECT_TRUE(contains(verdict(25.0, 30), " farther in the field than simulated ("));
  EXPECT_TRUE(contains(verdict(-25.0, 30), " less far in the field than simulated ("));
  EXPECT_TRUE(contains(verdict(25.0, 3), "3 measured stops, too few for a test"));
}

TEST(AnswerText, StandsWhatIsAlmostEmpty) {
  CampaignResults results = hand_made_results();
  results.runs.resize(1);
  results.crossings.clear();
  results.barriers.clear();
  const Comparison one = compared(results);
  EXPECT_EQ(sentences(one), "Block round<1> runs 10.0 m (1 run).\n");
  EXPECT_TRUE(contains(sentences(hand_made_results()),
                       "There are too few runs to compare runouts (4 compact, 2 elongated)."));
  for (const std::string& line : describe_results_and_warnings(one, summarise_key_results(one))) {
    EXPECT_EQ(line.find("nan"), std::string::npos) << line;
  }
  results.runs[0].result = ReleaseResult();
  results.runs[0].result.stop_reason = StopReason::kError;
  results.runs[0].result.final_state.position = Vec3::Constant(NAN);
  const Comparison failed = compared(std::move(results));
  EXPECT_TRUE(contains(sentences(failed), "No run of 1 came to rest (1 failed)"));
}

TEST(AnswerText, TheFirstScreenHasTheCautionsAndNoSettings) {
  const Comparison comparison = compared(hand_made_results());
  std::string text;
  for (const std::string& line :
       describe_results_and_warnings(comparison, summarise_key_results(comparison)))
    text += line + "\n";
  EXPECT_TRUE(contains(text, "- The classes differ in mass (compact 300 kg, elongated 500 kg)"));
  for (const char* setting : {"k_n", "1e-05", "clast 0"}) {
    EXPECT_EQ(text.find(setting), std::string::npos) << setting;
  }
  const std::string html = format_head_section(comparison, summarise_key_results(comparison));
  EXPECT_EQ(unbalanced(html), "");
  EXPECT_TRUE(contains(html, "<p class=\"answer\">"));
  EXPECT_EQ(html.find("k_n"), std::string::npos);
}

TEST(AnswerText, WhatTheCampaignAskedForIsNoWarning) {
  CampaignResults results = hand_made_results();
  results.blocks[0].scale = 1.25;
  results.warnings = {describe_block_scale(results.blocks[0]),
                      "block long: its underside was not seen"};
  const Comparison comparison = compared(std::move(results));
  for (const std::string& warning : comparison.warnings) {
    EXPECT_EQ(warning.find("is scaled by"), std::string::npos);
  }
  const std::string html = format_provenance_section(comparison);
  EXPECT_TRUE(contains(html, "As requested, block round&lt;1&gt; is scaled by 1.25 to 300 kg."));
  EXPECT_TRUE(contains(html, "its underside was not seen"));
  EXPECT_EQ(format_head_section(comparison, summarise_key_results(comparison)).find("underside"),
            std::string::npos);
}

}  // namespace
}  // namespace clast
