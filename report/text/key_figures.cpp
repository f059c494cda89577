#include "report/text/key_figures.hpp"

#include <algorithm>

#include "core/number_text.hpp"
#include "report/text/plain_numbers.hpp"
#include "report/text/subject_words.hpp"

namespace clast {

using namespace report_detail;
namespace {

/// Values of the classes, or of all where there is one: "45 / 32 m".
struct Pair {
  std::string values, ranges;

  void add(const std::string& value, const std::string& range) {
    values += (values.empty() ? "" : " / ") + value;
    if (!range.empty()) ranges += (ranges.empty() ? "" : " / ") + range;
  }
};

std::string class_names(const Comparison& comparison, const FileSummary& statement) {
  std::string names;
  if (statement.classes.size() < 2) return names;
  for (const RunoutEstimate& one : statement.classes) {
    names += (names.empty() ? ", " : " / ") + comparison.groups[one.group].key;
  }
  return names;
}

/// Ranges, with what they are over.
std::string drawn_ranges(const std::string& ranges, const FileSummary& statement) {
  return ranges.empty() || statement.draws == 0 ? ranges : ranges + kOverDrawsText;
}

KeyFigure runout_figure(const Comparison& comparison, const FileSummary& statement) {
  std::vector<RunoutEstimate> shown = statement.classes;
  if (shown.size() < 2) shown = {statement.all};
  int decimals = 2;
  for (const RunoutEstimate& one : shown) {
    if (one.is_representative())
      decimals = std::min(decimals, decimals_of_length(one.mean, one.interval));
  }
  Pair means, medians, farthest;
  for (const RunoutEstimate& one : shown) {
    means.add(one.is_representative() ? format_decimals(one.mean, decimals) : "?",
              one.is_representative() && one.interval
                  ? format_decimals(one.interval->low, decimals) + " to " +
                        format_decimals(one.interval->high, decimals)
                  : "");
    medians.add(one.is_representative() ? format_decimals(one.median, decimals) : "?", "");
    farthest.add(one.is_representative() ? format_decimals(one.p95, decimals) : "?", "");
  }
  const bool some = std::any_of(shown.begin(), shown.end(),
                                [](const RunoutEstimate& one) { return one.is_representative(); });
  return {means.values + " m", "mean runout" + class_names(comparison, statement),
          drawn_ranges(means.ranges, statement),
          some ? "half stop before " + medians.values + " m, 95 % before " + farthest.values + " m"
               : ""};
}

/// Formats a value for each class with passages, and the largest: "compact 33; largest 37 kJ".
std::string by_class(const Comparison& comparison, const BarrierSummary& passage,
                     double CrossingEstimate::*value, std::string (*as_limit)(double),
                     double CrossingEstimate::*largest, std::string (*format)(double)) {
  std::string text;
  for (const CrossingEstimate& share : passage.classes) {
    if (share.crossed == 0) continue;
    text += (text.empty() ? "" : ", ") + comparison.groups[share.group].key + " " +
            as_limit(share.*value) +
            (share.largest ? " (" + format_count(share.crossed, "passage") + ")" : "");
  }
  if (passage.all.largest) return text;
  return text + (text.empty() ? "" : "; ") + "largest " + format(passage.all.*largest);
}

std::vector<KeyFigure> barrier_figures(const Comparison& comparison, const FileSummary& statement) {
  const BarrierSummary& passage = statement.passages.front();
  const BarrierText words = barrier_text(comparison, passage.line);
  std::vector<CrossingEstimate> shown = passage.classes;
  if (shown.empty()) shown = {passage.all};
  Pair pair;
  for (const CrossingEstimate& share : shown) {
    std::string value = format_percentage(share.passing_probability), range;
    if (share.interval) range = format_percentage_interval(*share.interval);
    for (std::string* text : {&value, &range}) {
      if (text->ends_with(" %")) text->resize(text->size() - 2);
    }
    pair.add(value, range);
  }
  const CrossingEstimate& all = passage.all;
  const std::string limit =
      all.largest ? "largest of " + format_count(all.crossed, "passage") : "95 % lie below";
  std::vector<KeyFigure> figures = {
      {pair.values + " %", words.pass + " " + words.name + class_names(comparison, statement),
       drawn_ranges(pair.ranges, statement),
       std::to_string(all.crossed) + " of " + format_count(all.started, "run") +
           (all.crossed == 0 ? ""
                             : "; speed there: " + limit + " " + format_speed_limit(all.speed) +
                                   format_in_brackets(format_range_by_draw(all.speed_range,
                                                                           format_speed_limit)))}};
  if (all.crossed == 0) return figures;
  figures.push_back({format_energy_limit(all.energy), "energy at " + words.name + ": " + limit,
                     format_range_by_draw(all.energy_range, format_energy_limit),
                     by_class(comparison, passage, &CrossingEstimate::energy, format_energy_limit,
                              &CrossingEstimate::largest_energy, format_energy)});
  figures.push_back({format_height_limit(all.top),
                     "top of the blocks at " + words.name + ": " + limit,
                     format_range_by_draw(all.top_range, format_height_limit),
                     by_class(comparison, passage, &CrossingEstimate::top, format_height_limit,
                              &CrossingEstimate::largest_top, format_height) +
                         "; centres " + format_height_limit(all.height)});
  return figures;
}

}  // namespace

std::vector<KeyFigure> select_key_figures(const Comparison& comparison, const KeyResults& answer) {
  constexpr std::size_t kMost = 4;
  std::vector<KeyFigure> figures;
  if (answer.file_summaries.size() == 1) {
    const FileSummary& statement = answer.file_summaries.front();
    figures.push_back(runout_figure(comparison, statement));
    if (!statement.passages.empty()) {
      for (KeyFigure& figure : barrier_figures(comparison, statement)) {
        figures.push_back(std::move(figure));
      }
    } else if (statement.all.is_representative()) {
      const int decimals = decimals_of_length(statement.all.farthest);
      figures.push_back({format_length(statement.all.p95, decimals), "95 % stop before", ""});
      figures.push_back({format_length(statement.all.farthest, decimals), "farthest stop", ""});
    }
    return figures;
  }
  for (const FileSummary& statement : answer.file_summaries) {
    if (figures.size() == kMost) break;
    KeyFigure figure = runout_figure(comparison, statement);
    figure.label = results_file_label(comparison, *statement.file) + ": " + figure.label;
    figures.push_back(std::move(figure));
    if (answer.file_summaries.size() > 2 || statement.passages.empty()) continue;
    figure = barrier_figures(comparison, statement).front();
    figure.label = results_file_label(comparison, *statement.file) + ": " + figure.label;
    figures.push_back(std::move(figure));
  }
  return figures;
}

}  // namespace clast
