#include "report/pages/passage_charts.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "report/charts/palette.hpp"
#include "report/html/html_page.hpp"
#include "report/pages/realisation_traces.hpp"
#include "report/pages/report_groups.hpp"
#include "report/text/plain_numbers.hpp"
#include "report/text/subject_words.hpp"

namespace clast::report_detail {
namespace {

using PassageRealisations = std::vector<const RealisationCrossings*>;

std::vector<PassageRealisations> passages_by_file(const std::vector<RealisationCrossings>& all,
                                                  std::size_t line) {
  std::vector<PassageRealisations> files;
  for (const RealisationCrossings& one : all) {
    if (one.line != line) continue;
    if (files.empty() || files.back().front()->file != one.file) files.emplace_back();
    files.back().push_back(&one);
  }
  return files;
}

/// Goes on a little after the last passage, so that its step is seen.
RealisationCurve with_end(RealisationCurve curve) {
  constexpr double kFarther = 1.03;
  if (curve.time.empty()) return curve;
  curve.time.push_back(kFarther * curve.time.back());
  for (std::vector<double>* values : {&curve.mean, &curve.minimum, &curve.maximum}) {
    values->push_back(values->back());
  }
  return curve;
}

std::string passage_chart(const Comparison& comparison,
                          const std::vector<PassageRealisations>& files, const ChartAxes& axes,
                          const CrossingValue& value) {
  std::vector<ChartTrace> traces;
  for (std::size_t i = 0; i < files.size(); ++i) {
    const RealisationCurve curve = with_end(passage_curve(files[i], value));
    const std::string name =
        (has_several_files(comparison) ? results_file_label(comparison, files[i].front()->file)
                                       : "mean") +
        " of " + format_count(files[i].size(), "realisation");
    add_realisation_curve(traces, name, series_colour(i), ChartTrace::Kind::kSteps, curve,
                          files[i].size());
  }
  return draw_plotly_chart(axes, traces);
}

/// A row of the table.
struct PassageFigure {
  const char* words;
  double unit = 1.0;  ///< on values
  std::function<double(const RealisationCrossings&)> value;
};

const std::vector<PassageFigure>& figures() {
  using Row = RealisationCrossings;
  static const std::vector<PassageFigure> kFigures = {
      {"blocks that pass", 1.0,
       [](const Row& row) { return static_cast<double>(row.passages.size()); }},
      {"mass, kg", 1.0,
       [](const Row& row) { return row.sum([](const BlockCrossing& one) { return one.mass; }); }},
      {"volume, m\xC2\xB3", 1.0,
       [](const Row& row) { return row.sum([](const BlockCrossing& one) { return one.volume; }); }},
      {"energy, kJ", kKilojoulesPerJoule,
       [](const Row& row) { return row.sum([](const BlockCrossing& one) { return one.energy; }); }},
      {"first passage, s", 1.0, &Row::first},
      {"time from the first to the last passage, s", 1.0,
       [](const Row& row) { return row.last() - row.first(); }},
      {"most blocks in 1 s", 1.0, [](const Row& row) { return row.max_blocks_in_window.value; }},
      {"most mass in 1 s, kg", 1.0, [](const Row& row) { return row.max_mass_in_window.value; }},
      {"most energy in 1 s, kJ", kKilojoulesPerJoule,
       [](const Row& row) { return row.max_energy_in_window.value; }},
      {"largest energy of a block, kJ", kKilojoulesPerJoule, &Row::largest_energy}};
  static_assert(kPassageWindow == 1.0, "the heads say so");
  return kFigures;
}

}  // namespace

std::string draw_crossing_charts(const Comparison& comparison,
                                 const std::vector<RealisationCrossings>& all, std::size_t line) {
  const std::vector<PassageRealisations> files = passages_by_file(all, line);
  const std::string at = comparison.lines[line].name + ": ";
  const char* time = "time since the first release, s";
  return passage_chart(comparison, files, {at + "blocks that have passed", time, "blocks"},
                       [](const BlockCrossing&) { return 1.0; }) +
         passage_chart(comparison, files, {at + "mass that has passed", time, "mass, kg"},
                       [](const BlockCrossing& passage) { return passage.mass; }) +
         passage_chart(
             comparison, files, {at + "energy that has passed", time, "kinetic energy, kJ"},
             [](const BlockCrossing& passage) { return kKilojoulesPerJoule * passage.energy; });
}

std::string describe_crossings(const Comparison& comparison,
                               const std::vector<RealisationCrossings>& all, std::size_t line) {
  std::string html;
  for (const PassageRealisations& realisations : passages_by_file(all, line)) {
    double blocks = 0.0, mass = 0.0, energy = 0.0, single = 0.0;
    for (const RealisationCrossings* one : realisations) {
      blocks = std::max(blocks, one->max_blocks_in_window.value);
      mass = std::max(mass, one->max_mass_in_window.value);
      energy = std::max(energy, one->max_energy_in_window.value);
      single = std::max(single, one->largest_energy);
    }
    if (blocks == 0.0) continue;
    const std::uint32_t file = realisations.front()->file;
    const bool at_once = comparison.results[file].persistent_blocks->at_once;
    html += format_paragraph(
        comparison.lines[line].name +
        (has_several_files(comparison) ? ", " + results_file_label(comparison, file) : "") +
        ": within 1 s at most " + format_count(static_cast<std::size_t>(blocks), "block") +
        ", at most " + format_mass(std::ceil(mass)) + " and at most " +
        format_energy_limit(energy) + " pass; the largest energy of a " + "single block is " +
        format_energy_limit(single) + ". From " + format_count(realisations.size(), "realisation") +
        (at_once ? "." : " with blocks released one after another."));
  }
  return html;
}

std::string format_crossing_table(const Comparison& comparison,
                                  const std::vector<RealisationCrossings>& all, std::size_t line) {
  const std::vector<PassageRealisations> files = passages_by_file(all, line);
  if (files.empty()) return "";
  std::vector<std::string> heads = {"together"};
  for (const PassageRealisations& realisations : files) {
    const std::string of_file =
        has_several_files(comparison)
            ? "file " + std::to_string(realisations.front()->file + 1) + ": "
            : "";
    for (const char* head : {"mean", "std", "least", "most"}) heads.push_back(of_file + head);
  }
  HtmlTable table(heads, 1);
  for (const PassageFigure& figure : figures()) {
    std::vector<std::string> cells = {figure.words};
    for (const PassageRealisations& realisations : files) {
      std::vector<double> values;
      for (const RealisationCrossings* one : realisations) {
        const double value = figure.unit * figure.value(*one);
        if (std::isfinite(value)) values.push_back(value);
      }
      const SampleSummary summary = summarise_sample(values);
      const bool any = !values.empty();
      cells.push_back(any ? format_significant_digits(summary.mean) : "-");
      cells.push_back(values.size() > 1 ? format_significant_digits(summary.std) : "-");
      cells.push_back(
          any ? format_significant_digits(*std::min_element(values.begin(), values.end())) : "-");
      cells.push_back(any ? format_significant_digits(summary.max) : "-");
    }
    table.row(std::move(cells));
  }
  return format_paragraph(
             "The statistics are over realisations. Each block is counted once; blocks that pass "
             "within 1 s of each other are counted together. Each realisation is a row of "
             "passages.csv, and each passage is a row of passage_curves.csv.") +
         table.html();
}

}  // namespace clast::report_detail
