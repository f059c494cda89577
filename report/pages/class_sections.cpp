#include "report/pages/report_sections.hpp"

#include <algorithm>
#include <set>

#include "core/angle.hpp"
#include "report/charts/plotly_chart.hpp"
#include "report/html/html_page.hpp"
#include "report/pages/report_groups.hpp"

namespace clast::report_detail {

std::string format_class_section(const Comparison& comparison) {
  std::vector<std::string> heads = {"class",
                                    "blocks",
                                    "runs",
                                    "at rest",
                                    "mean mass, kg",
                                    "runout mean \xC2\xB1 std, m",
                                    "runout median, m",
                                    "runout p95, m",
                                    "runout max, m",
                                    "lateral mean \xC2\xB1 std, deg"};
  for (const BarrierLine& line : comparison.lines) heads.push_back("past " + line.name);
  HtmlTable table(heads, 1);
  std::vector<std::size_t> groups = select_groups_of_kind(comparison, RunGroupKind::kGarcia);
  for (const std::size_t g : select_groups_of_kind(comparison, RunGroupKind::kSneedFolk))
    groups.push_back(g);
  for (const std::size_t g : select_groups_of_kind(comparison, RunGroupKind::kAll))
    groups.push_back(g);
  for (const std::size_t g : groups) {
    const RunGroup& group = comparison.groups[g];
    const DepositStatistics& deposit = comparison.deposits[g];
    std::set<std::string> blocks;
    double mass = 0.0;
    for (const std::size_t row : group.rows) {
      blocks.insert(comparison.rows[row].block->id);
      mass += comparison.rows[row].block->mass;
    }
    std::vector<std::string> cells = {
        short_group_name(group),
        std::to_string(blocks.size()),
        std::to_string(deposit.started),
        std::to_string(deposit.stops.rest),
        format_significant_digits(mass / static_cast<double>(group.rows.size()), 4),
        format_mean_and_deviation(deposit.runout, 1),
        format_summary_value(deposit.runout.median, deposit.runout, 1),
        format_summary_value(deposit.runout.p95, deposit.runout, 1),
        format_summary_value(deposit.runout.max, deposit.runout, 1),
        format_mean_and_deviation(deposit.lateral, 1, kDegreesPerRadian)};
    for (std::size_t line = 0; line < comparison.lines.size(); ++line) {
      std::string cell = "-";
      for (const BarrierGroupStatistics& barrier : comparison.barriers) {
        if (barrier.line == line && barrier.group_index == g)
          cell = format_percent(barrier.probability);
      }
      cells.push_back(cell);
    }
    table.row(std::move(cells));
  }
  return format_section(
      "Shape classes side by side",
      format_paragraph("Compact and elongated blocks are distinguished by s_c. Runout and lateral "
                       "angle are statistics of the runs that came to rest; the fractions that "
                       "pass barriers refer to all runs.") +
          table.html());
}

std::string format_block_section(const Comparison& comparison) {
  // Two tables, since one is wider than a page.
  HtmlTable shapes({"block", "Garcia", "Sneed-Folk", "Zingg", "mass, kg", "L, m", "I, m", "S, m"},
                   4);
  HtmlTable stops({"block", "runs", "at rest", "left terrain", "max time", "error",
                   "runout mean \xC2\xB1 std, m", "runout p95, m", "lateral mean \xC2\xB1 std, deg",
                   "fastest, m/s"},
                  1);
  for (const std::size_t g : select_groups_of_kind(comparison, RunGroupKind::kBlock)) {
    const RunGroup& group = comparison.groups[g];
    const DepositStatistics& deposit = comparison.deposits[g];
    const BlockSummary& block = *comparison.rows[group.rows.front()].block;
    double fastest = 0.0;
    for (const std::size_t row : group.rows) {
      fastest = std::max(fastest, comparison.rows[row].record->result.max_speed);
    }
    shapes.row({short_group_name(group), block.garcia, block.sneed_folk, block.zingg,
                format_significant_digits(block.mass, 4), format_significant_digits(block.axes.L),
                format_significant_digits(block.axes.I), format_significant_digits(block.axes.S)});
    stops.row({short_group_name(group), std::to_string(deposit.started),
               std::to_string(deposit.stops.rest), std::to_string(deposit.stops.left_terrain),
               std::to_string(deposit.stops.max_time), std::to_string(deposit.stops.error),
               format_mean_and_deviation(deposit.runout, 1),
               format_summary_value(deposit.runout.p95, deposit.runout, 1),
               format_mean_and_deviation(deposit.lateral, 1, kDegreesPerRadian),
               format_fixed(fastest, 1)});
  }
  return format_section(
      "Blocks",
      format_folded_section("Shapes: L, I, S are the sides of the smallest box", shapes.html(),
                            PrintedState::kOpen) +
          format_folded_section("Runs of every block", stops.html(), PrintedState::kOpen));
}

std::string format_runout_section(const Comparison& comparison) {
  const auto at_rest = [&](std::size_t row) {
    return comparison.rows[row].record->result.stop_reason == StopReason::kRest;
  };
  const auto along = [&](std::size_t row) {
    return at_rest(row) ? std::optional(comparison.rows[row].runout) : std::nullopt;
  };
  const auto lateral = [&](std::size_t row) {
    return at_rest(row) ? std::optional(comparison.rows[row].lateral * kDegreesPerRadian)
                        : std::nullopt;
  };
  const std::vector<ChartSeries> by_class =
      make_value_series(comparison, RunGroupKind::kGarcia, along);
  std::string charts = "<div class=\"charts\">\n";
  charts += draw_plotly_chart({"Runout by class", "runout, m", "fraction of runs", true},
                              make_histogram_traces(by_class));
  charts += draw_plotly_chart(
      {"Lateral angle by class", "angle, deg (+ to the right)", "fraction of runs", true},
      make_histogram_traces(make_value_series(comparison, RunGroupKind::kGarcia, lateral)));
  charts += draw_plotly_chart(
      {"Fraction of runs that stop before a runout, by class", "runout, m", "fraction", true},
      make_cumulative_traces(by_class));
  // Shades and dashes distinguish a dozen curves of either class.
  constexpr std::size_t kMaxCurves = 24;
  if (select_groups_of_kind(comparison, RunGroupKind::kBlock).size() <= kMaxCurves) {
    charts += draw_plotly_chart(
        {"Fraction of runs that stop before a runout, by block", "runout, m", "fraction", true},
        make_cumulative_traces(make_value_series(comparison, RunGroupKind::kBlock, along)));
  }
  return format_section(
      "Runout",
      format_paragraph("Runout of the runs that came to rest; the number of runs is in brackets.") +
          charts + "</div>\n");
}

}  // namespace clast::report_detail
