#include "report/text/key_results_text.hpp"

#include <algorithm>
#include <cmath>

#include "core/number_text.hpp"
#include "report/text/capital.hpp"
#include "report/text/key_figures.hpp"
#include "report/text/measured_text.hpp"
#include "report/text/plain_numbers.hpp"
#include "report/text/subject_words.hpp"

namespace clast {

using namespace report_detail;
namespace {

constexpr std::size_t kMaxStatements = 3;        // in full
constexpr std::size_t kMaxOthers = 2;            // barriers beside the first
constexpr std::size_t kMinRunsForFraction = 20;  // runs for "95 % stop before"

/// Who runs: "compact blocks", "block B01", "the blocks".
std::string blocks_of(const Comparison& comparison, std::size_t group) {
  const RunGroup& runs = comparison.groups[group];
  const std::string& first = comparison.rows[runs.rows.front()].block->library_block();
  const bool alone = std::all_of(runs.rows.begin(), runs.rows.end(), [&](std::size_t row) {
    return comparison.rows[row].block->library_block() == first;
  });
  if (alone) return "block " + first;
  return runs.kind == RunGroupKind::kGarcia ? runs.key + " blocks" : "the blocks";
}

/// "3 to 12 m": " over draws of the ground parameters" where the range is over draws, and "" else.
std::string by_draw(std::size_t draws) { return draws > 0 ? kOverDrawsText : ""; }

/// Describes what a range covers, such as ", for runs of these 3 blocks only".
/// @param named  the sentence names the one block there is
std::string covered_by(const FileSummary& statement, bool named) {
  if (named || statement.samples_blocks) return by_draw(statement.draws);
  return by_draw(statement.draws) + ", for runs of " +
         (statement.blocks == 1 ? "this block"
                                : "these " + format_count(statement.blocks, "block")) +
         " only";
}

/// Why runs have no runout: "12 left the surveyed terrain, 3 were still moving".
std::string other_ends(const StopCounts& stops) {
  std::string text;
  const auto add = [&](std::size_t count, const std::string& what) {
    if (count > 0) text += (text.empty() ? "" : ", ") + std::to_string(count) + " " + what;
  };
  add(stops.left_terrain, "left the surveyed terrain");
  add(stops.max_time, "were still moving at the time limit");
  add(stops.error, "failed");
  return text;
}

/// "Of the 84 % of runs that came to rest, "; empty where all did.
std::string at_rest_only(const RunoutEstimate& all) {
  if (all.at_rest == all.started) return "";
  return "among the " +
         format_percentage(static_cast<double>(all.at_rest) / static_cast<double>(all.started)) +
         " of runs that came to rest, ";
}

std::string mean_runout(const Comparison& comparison, const FileSummary& statement) {
  const RunoutEstimate& all = statement.all;
  if (all.at_rest == 0 || 2 * all.at_rest < all.started) {
    const std::string ends = other_ends(statement.stops);
    return (all.at_rest == 0 ? "no run" : "only " + std::to_string(all.at_rest)) + " of " +
           std::to_string(all.started) + " came to rest" + (ends.empty() ? "" : " (" + ends + ")") +
           ", so the runout is not known";
  }
  const std::size_t shown = statement.classes.size() == 1 ? statement.classes[0].group : all.group;
  const std::string who = blocks_of(comparison, shown);
  const int decimals = decimals_of_length(all.mean, all.interval);
  const bool named = who.starts_with("block ");
  const std::string text =
      at_rest_only(all) + who + (named ? " runs " : " run ") + format_length(all.mean, decimals);
  if (!all.is_representative()) return text + " (" + format_count(all.at_rest, "run") + ")";
  return text + " on average" +
         (all.interval ? " (" + format_length_interval(*all.interval, decimals) +
                             covered_by(statement, named) + ")"
                       : "") +
         (all.at_rest < kMinRunsForFraction
              ? ", at most " + format_length(all.farthest, decimals)
              : "; 95 % stop before " + format_length(all.p95, decimals));
}

/// "; half of both stop within 17 m: the means differ because more of the compact blocks run far
/// beyond the median"
std::string few_run_on(const RunoutEstimate& farther, const RunoutEstimate& nearer,
                       const std::string& a, const std::string& b, int decimals) {
  const std::string first = format_length(farther.median, decimals);
  const std::string second = format_length(nearer.median, decimals);
  return (first == second ? "; half of both stop within " + first
                          : "; half of the " + a + " stop within " + first + ", half of the " + b +
                                " within " + second) +
         ": the means differ because more of the " + a + " blocks run far beyond the median";
}

std::string describe_difference(const Comparison& comparison, const FileSummary& statement) {
  const RunoutContrast& gap = *statement.class_contrast;
  const auto of = [&](std::size_t group) -> const RunoutEstimate& {
    return statement.classes[statement.classes[0].group == group ? 0 : 1];
  };
  const RunoutEstimate &farther = of(gap.farther), &nearer = of(gap.nearer);
  const std::string &a = comparison.groups[gap.farther].key, &b = comparison.groups[gap.nearer].key;
  const int decimals = decimals_of_length(gap.mean_difference, gap.interval);
  const std::string interval = gap.interval
                                   ? " (" + format_length_interval(*gap.interval, decimals) +
                                         covered_by(statement, false) + ")"
                                   : "";
  const std::string prefix = at_rest_only(statement.all);
  const std::string means = a + " and " + b + " blocks run " +
                            format_decimals(farther.mean, decimals) + " and " +
                            format_length(nearer.mean, decimals) + " on average";
  switch (gap.verdict) {
    case ContrastVerdict::kSignificant:
      return prefix + a + " blocks run " + format_length(gap.mean_difference, decimals) +
             " farther than " + b + " ones" + (gap.due_to_few_runs ? " on average" : "") +
             interval + (gap.due_to_few_runs ? few_run_on(farther, nearer, a, b, decimals) : "");
    case ContrastVerdict::kDistributionDiffers:
      return prefix + means + ", a difference that is not significant" + interval +
             "; but the distributions of their runouts differ";
    case ContrastVerdict::kInsignificantAfterCorrection:
    case ContrastVerdict::kInsignificant:
      return prefix + means + "; " +
             (gap.interval && gap.interval->low > 0.0
                  ? "among all the comparisons made, a difference of this size" + interval +
                        " is not significant"
                  : "the difference is not significant" + interval);
    case ContrastVerdict::kGroundDependent:
      return prefix + means + "; which class runs farther depends on the ground parameters" +
             interval;
    case ContrastVerdict::kUntested:
      return prefix + means + "; with one realisation, significance cannot be tested";
    case ContrastVerdict::kTooFewValues:
      break;
  }
  const std::string ends = other_ends(statement.stops);
  if (ends.empty()) {
    return "there are too few runs to compare runouts (" + std::to_string(farther.at_rest) + " " +
           a + ", " + std::to_string(nearer.at_rest) + " " + b + ")";
  }
  return "runouts cannot be compared: " + std::to_string(farther.at_rest) + " of " +
         std::to_string(farther.started) + " " + a + " and " + std::to_string(nearer.at_rest) +
         " of " + std::to_string(nearer.started) + " " + b + " blocks came to rest (" + ends + ")";
}

std::string with_interval(const CrossingEstimate& share, std::size_t draws) {
  return share.interval ? " (" + format_percentage_interval(*share.interval) + by_draw(draws) + ")"
                        : "";
}

/// "34 % of compact and 2 % of elongated blocks pass EC22".
std::string share_sentence(const Comparison& comparison, const BarrierSummary& passage,
                           std::size_t draws) {
  const BarrierText words = barrier_text(comparison, passage.line);
  if (passage.all.crossed == 0) {
    const std::string text = "none of " + format_count(passage.all.started, "run") + " " +
                             words.pass + "es " + words.name;
    if (!passage.all.interval || draws > 0) return text;
    return text + " (the 95 % interval reaches " + format_percentage(passage.all.interval->high) +
           ")";
  }
  if (passage.all.crossed == passage.all.started) {
    return "all " + format_count(passage.all.started, "run") + " " + words.pass + " " + words.name +
           with_interval(passage.all, draws);
  }
  if (passage.classes.size() < 2) {
    return format_percentage(passage.all.passing_probability) + " of the blocks " + words.pass +
           " " + words.name + with_interval(passage.all, draws);
  }
  return format_percentage(passage.classes[0].passing_probability) + " of " +
         comparison.groups[passage.classes[0].group].key + " and " +
         format_percentage(passage.classes[1].passing_probability) + " of " +
         comparison.groups[passage.classes[1].group].key + " blocks " + words.pass + " " +
         words.name;
}

/// ". Of the blocks that pass, 95 % carry less than 43 kJ, and the tops of 95 % stay below 1.6 m".
std::string strength_of(const BarrierSummary& passage, const std::string& pass) {
  if (passage.all.crossed == 0) return "";
  const std::string energy =
      format_energy_limit(passage.all.energy) +
      format_in_brackets(format_range_by_draw(passage.all.energy_range, format_energy_limit));
  const std::string height =
      format_height_limit(passage.all.top) +
      format_in_brackets(format_range_by_draw(passage.all.top_range, format_height_limit));
  if (!passage.all.largest) {
    return ". Of the blocks that " + pass + ", 95 % carry less than " + energy +
           ", and the tops of 95 % stay below " + height;
  }
  return passage.all.crossed == 1
             ? ", with " + energy + " and its top at most " + height + " above the ground"
             : ", the " + std::to_string(passage.all.crossed) + " of them with at most " + energy +
                   " and their tops at most " + height + " above the ground";
}

std::string describe_passages(const Comparison& comparison, const FileSummary& statement) {
  if (statement.passages.empty()) return "";
  const BarrierSummary& first = statement.passages.front();
  std::string text = capitalized(share_sentence(comparison, first, statement.draws)) +
                     strength_of(first, barrier_text(comparison, first.line).pass) + ".";
  const std::size_t shown = std::min(statement.passages.size() - 1, kMaxOthers);
  for (std::size_t i = 1; i <= shown; ++i) {
    text +=
        " " + capitalized(share_sentence(comparison, statement.passages[i], statement.draws)) + ".";
  }
  const std::size_t left = statement.passages.size() - 1 - shown;
  if (left > 0) text += " " + format_count(left, "more barrier") + " below.";
  return text;
}

/// Describes the effect of the ground on the runs of all classes together.
std::string describe_ground(const Comparison& comparison, const FileSummary& statement) {
  if (statement.draws == 0) return "";
  std::string text;
  if (const auto& range = statement.all.interval) {
    text =
        "mean runout is " + format_length_interval(*range, decimals_of_length(range->high, *range));
  }
  for (const BarrierSummary& passage : statement.passages) {
    if (!passage.all.interval) continue;
    const BarrierText words = barrier_text(comparison, passage.line);
    text += (text.empty() ? "" : ", ") + format_percentage_interval(*passage.all.interval) + " " +
            words.pass + " " + words.name;
  }
  if (text.empty()) return "";
  return " Over " + std::to_string(statement.draws) + " draws of the ground, " + text +
         (is_ninety_percent_interval(statement.draws) ? " (ranges of nine draws in ten)." : ".");
}

std::string sentence_of(const Comparison& comparison, const FileSummary& statement) {
  const std::string runout = statement.class_contrast ? describe_difference(comparison, statement)
                                                      : mean_runout(comparison, statement);
  const std::string prefix =
      statement.file ? capitalized(results_file_label(comparison, *statement.file)) + ": " : "";
  const std::string passages = describe_passages(comparison, statement);
  return prefix + (prefix.empty() ? capitalized(runout) : runout) + "." +
         (passages.empty() ? "" : " " + passages) + describe_ground(comparison, statement);
}

std::string describe_files(const Comparison& comparison, const KeyResults& answer) {
  const RunoutContrast& gap = *answer.files;
  const std::string a = results_file_label(comparison, *comparison.groups[gap.farther].file);
  const std::string b = results_file_label(comparison, *comparison.groups[gap.nearer].file);
  const int decimals = decimals_of_length(gap.mean_difference, gap.interval);
  const std::string interval = gap.interval
                                   ? " (" + format_length_interval(*gap.interval, decimals) +
                                         (answer.has_draws() ? kOverDrawsText : "") + ")"
                                   : "";
  if (gap.verdict == ContrastVerdict::kSignificant) {
    return "Blocks run " + format_length(gap.mean_difference, decimals) + " farther in " + a +
           " than in " + b + interval + ".";
  }
  if (gap.verdict == ContrastVerdict::kTooFewValues) return "";
  if (gap.verdict == ContrastVerdict::kUntested) {
    return "Blocks run " + format_length(gap.mean_difference, decimals) + " farther in " + a +
           " than in " + b + "; with one realisation, significance cannot be tested.";
  }
  if (gap.verdict == ContrastVerdict::kGroundDependent) {
    return "Whether blocks run farther in " + a + " or in " + b +
           " depends on the ground parameters" + interval + ".";
  }
  return "Blocks run " + format_length(gap.mean_difference, decimals) + " farther in " + a +
         " than in " + b + "; the difference is not significant" + interval + ".";
}

/// "330 to 580 kg".
std::string describe_masses(const Comparison& comparison) {
  double low = INFINITY, high = 0.0;
  for (const RunRow& row : comparison.rows) {
    low = std::min(low, row.block->mass);
    high = std::max(high, row.block->mass);
  }
  const std::string from = format_mass(low), to = format_mass(high);
  return from == to ? to : from.substr(0, from.find(' ')) + " to " + to;
}

}  // namespace

std::vector<std::string> describe_key_results(const Comparison& comparison,
                                              const KeyResults& answer) {
  std::vector<std::string> sentences;
  if (answer.files) {
    const std::string between = describe_files(comparison, answer);
    if (!between.empty()) sentences.push_back(between);
  }
  const std::size_t shown = std::min(answer.file_summaries.size(), kMaxStatements);
  for (std::size_t i = 0; i < shown; ++i) {
    sentences.push_back(sentence_of(comparison, answer.file_summaries[i]));
  }
  if (shown < answer.file_summaries.size()) {
    sentences.push_back(format_count(answer.file_summaries.size() - shown, "more file") +
                        " below.");
  }
  return sentences;
}

std::string describe_runs(const Comparison& comparison) {
  std::size_t blocks = 0, classes = 0;
  for (const RunGroup& group : comparison.groups) {
    if (group.file) continue;
    blocks += group.kind == RunGroupKind::kBlock;
    classes += group.kind == RunGroupKind::kGarcia;
  }
  std::string text = format_count(comparison.rows.size(), "run") + " of " +
                     format_count(blocks, "block") + " (" + describe_masses(comparison) + ") in " +
                     format_count(classes, "shape class", "shape classes");
  const std::size_t files = comparison.results.size();
  return files > 1 ? text + ", from " + format_count(files, "file") : text;
}

std::string describe_intervals(const KeyResults& answer) {
  std::size_t fewest = SIZE_MAX, draws = 0;
  bool realisations = false, all_drawn = true;
  for (const FileSummary& statement : answer.file_summaries) {
    draws = std::max(draws, statement.draws);
    if (statement.draws > 0) continue;
    all_drawn = false;
    fewest = std::min(fewest, statement.clusters);
    realisations = realisations || statement.clusters_are_realisations;
  }
  const std::string over_draws =
      draws == 0
          ? ""
          : "Ranges over draws of the ground parameters cover " +
                std::string(is_ninety_percent_interval(draws) ? "nine draws in ten" : "all draws") +
                "; these ranges do not cover other release points or blocks.";
  if (all_drawn) return over_draws;
  std::string ranges = "Ranges in brackets are 95 % intervals, from ";
  if (realisations && fewest == 1) {
    ranges = "With one realisation, no interval can be given for runouts and fractions.";
  } else if (realisations) {
    ranges += std::to_string(fewest) + " realisations.";
  } else {
    ranges +=
        fewest == 1 ? "runs of one release point." : std::to_string(fewest) + " release points.";
  }
  return ranges + (over_draws.empty() ? "" : " " + over_draws);
}

std::string describe_validity_limits(const Comparison& comparison, const KeyResults& answer) {
  double heaviest = 0.0;
  for (const RunRow& row : comparison.rows) heaviest = std::max(heaviest, row.block->mass);
  std::string text = "Not run: blocks above " + format_mass(heaviest);
  const auto& file_summaries = answer.file_summaries;
  const bool one_ground = std::all_of(file_summaries.begin(), file_summaries.end(),
                                      [](const FileSummary& one) { return one.draws == 0; });
  const bool one_point = std::any_of(
      file_summaries.begin(), file_summaries.end(),
      [](const FileSummary& one) { return one.clusters == 1 && !one.clusters_are_realisations; });
  if (one_ground) text += ", other ground";
  if (one_point) text += ", other release points";
  return text + ".";
}

std::vector<std::string> describe_results_and_warnings(const Comparison& comparison,
                                                       const KeyResults& answer) {
  std::vector<std::string> lines = {describe_runs(comparison), ""};
  const auto add = [&](const std::vector<std::string>& more) {
    lines.insert(lines.end(), more.begin(), more.end());
  };
  add(describe_key_results(comparison, answer));
  lines.emplace_back();
  std::size_t width = 0;
  const std::vector<KeyFigure> figures = select_key_figures(comparison, answer);
  for (const KeyFigure& figure : figures) width = std::max(width, figure.value.size());
  for (const KeyFigure& figure : figures) {
    lines.push_back("  " + figure.value + std::string(width - figure.value.size() + 2, ' ') +
                    figure.label + (figure.range.empty() ? "" : " (" + figure.range + ")") +
                    (figure.more.empty() ? "" : "; " + figure.more));
  }
  lines.push_back(describe_intervals(answer));
  lines.push_back(describe_validity_limits(comparison, answer));
  const std::vector<std::string> measured = describe_measured_stops(comparison);
  if (!measured.empty()) add({"", "Measured against simulated stops:"});
  add(measured);
  if (!comparison.cautions.empty()) add({"", "What could reverse this result:"});
  for (const ComparisonWarning& caution : comparison.cautions)
    lines.push_back("- " + caution.brief);
  return lines;
}

}  // namespace clast
