#include "report/pages/report_sections.hpp"

#include <algorithm>
#include <numeric>

#include "report/charts/plotly_chart.hpp"
#include "report/html/html_page.hpp"
#include "report/pages/passage_charts.hpp"
#include "report/pages/report_groups.hpp"
#include "study/compare/ground_draws.hpp"

namespace clast::report_detail {
namespace {

constexpr double kTurn = 2.0 * kPi;            // rad per revolution
constexpr const char* kDash = "\xE2\x80\x93";  // en dash, for ranges

/// Groups that met a barrier, classes first.
std::vector<const BarrierGroupStatistics*> shown_groups(const Comparison& comparison,
                                                        std::size_t line) {
  std::vector<const BarrierGroupStatistics*> shown;
  for (const RunGroupKind kind : {RunGroupKind::kGarcia, RunGroupKind::kBlock,
                                  RunGroupKind::kSneedFolk, RunGroupKind::kAll}) {
    for (const BarrierGroupStatistics& group : comparison.barriers) {
      const RunGroup& runs = comparison.groups[group.group_index];
      if (group.line == line && runs.kind == kind &&
          runs.file.has_value() == has_several_files(comparison)) {
        shown.push_back(&group);
      }
    }
  }
  return shown;
}

/// Appends the mean, p95 and maximum of a summary.
void append_summary(std::vector<std::string>& cells, const SampleSummary& summary, int decimals) {
  for (const double value : {summary.mean, summary.p95, summary.max}) {
    cells.push_back(format_summary_value(value, summary, decimals));
  }
}

std::string crossing_table(const Comparison& comparison, std::size_t line) {
  HtmlTable table({"group", "runs", "crossings", "probability", "95 % interval", "height mean, m",
                   "height p95, m", "height max, m", "top p95, m", "top max, m",
                   "clearance mean, m", "clearance p95, m", "clearance max, m"},
                  1);
  for (const BarrierGroupStatistics* group : shown_groups(comparison, line)) {
    const std::optional<Interval>& interval = group->interval;
    std::vector<std::string> cells = {
        short_group_name(comparison.groups[group->group_index]), std::to_string(group->started),
        std::to_string(group->crossed), format_percent(group->probability),
        interval ? format_fixed(100.0 * interval->low, 1) + kDash +
                       format_fixed(100.0 * interval->high, 1) + " %"
                 : "-"};
    append_summary(cells, group->height, 2);
    for (const double top : {group->top.p95, group->top.max}) {
      cells.push_back(format_summary_value(top, group->top, 2));
    }
    append_summary(cells, group->clearance, 2);
    table.row(std::move(cells));
  }
  return table.html();
}

/// Empty when nothing crossed.
std::string impact_table(const Comparison& comparison, std::size_t line) {
  bool any = false;
  HtmlTable table({"group", "speed mean, m/s", "speed p95, m/s", "speed max, m/s",
                   "energy mean, kJ", "energy p95, kJ", "energy max, kJ", "rotational fraction",
                   "rotation mean, rps", "rotation p95, rps", "rotation max, rps"},
                  1);
  for (const BarrierGroupStatistics* group : shown_groups(comparison, line)) {
    if (group->crossed == 0) continue;
    any = true;
    std::vector<std::string> cells = {short_group_name(comparison.groups[group->group_index])};
    append_summary(cells, group->speed, 1);
    for (const double energy : {group->total.mean, group->total.p95, group->total.max}) {
      cells.push_back(format_significant_digits(energy / 1000.0));
    }
    cells.push_back(
        group->total.mean > 0.0 ? format_percent(group->rotational.mean / group->total.mean) : "-");
    const SampleSummary& rate = group->rotation_rate;
    for (const double value : {rate.mean, rate.p95, rate.max}) {
      cells.push_back(format_fixed(value / kTurn, 2));
    }
    table.row(std::move(cells));
  }
  return any ? table.html() : std::string();
}

/// Describes which crossings of the line count, and how many had each direction.
std::string directions_of(const Comparison& comparison, std::size_t line) {
  const BarrierLine& barrier = comparison.lines[line];
  if (barrier.belongs_to_ring()) {
    return std::string(barrier.counts == BarrierLine::Counts::kEntries ? "entries" : "exits") +
           " are counted";
  }
  std::size_t crossed = 0, backward = 0;
  for (const BarrierGroupStatistics& group : comparison.barriers) {
    if (group.line != line || comparison.groups[group.group_index].kind != RunGroupKind::kAll)
      continue;
    if (comparison.groups[group.group_index].file) continue;
    crossed = group.crossed;
    backward = group.backward;
  }
  if (barrier.counts == BarrierLine::Counts::kForward) {
    return "only crossings from the left side of the line to the right side are counted; " +
           std::to_string(backward) + " runs first crossed it in the opposite direction";
  }
  return "both directions are counted: " + std::to_string(crossed - backward) +
         " runs first crossed it from the left side to the right side, " +
         std::to_string(backward) + " in the opposite direction";
}

/// "from (16.25, 50) to (16.25, 110) m"
std::string barrier_ends(const BarrierLine& barrier) {
  std::string points;
  for (const Vec2& point : barrier.vertices) {
    points += (points.empty() ? "From (" : " to (") + format_fixed(point.x(), 2) + ", " +
              format_fixed(point.y(), 2) + ")";
  }
  return points + " m";
}

std::string barrier_charts(const Comparison& comparison, std::size_t line) {
  const std::vector<const Crossing*> first = find_counted_crossings(comparison, line);
  const auto chart = [&](const std::string& title, const std::string& label, auto value) {
    return draw_plotly_chart(
        {title, label, "fraction of crossings", true},
        make_cumulative_traces(make_value_series(comparison, RunGroupKind::kGarcia,
                                                 [&](std::size_t row) -> std::optional<double> {
                                                   if (first[row] == nullptr) {
                                                     return std::nullopt;
                                                   }
                                                   return value(*first[row]);
                                                 }),
                               true));
  };
  return chart(comparison.lines[line].name + ": crossings above an energy",
               "total kinetic energy, kJ",
               [](const Crossing& c) {
                 return (c.translational_energy + c.rotational_energy) / 1000.0;
               }) +
         chart(comparison.lines[line].name + ": crossings above a height", "height above ground, m",
               [](const Crossing& c) { return c.height; }) +
         chart(comparison.lines[line].name + ": crossings faster than a speed", "speed, m/s",
               [](const Crossing& c) { return c.velocity.norm(); });
}

/// Counts the ground draws in all files; 0 if the ground is not drawn.
std::size_t draws_of_ground(const Comparison& comparison) {
  std::vector<std::size_t> all(comparison.rows.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  return group_rows_by_draw(comparison, all).size();
}

}  // namespace

std::string format_barrier_section(const ComparisonAnalyses& analyses) {
  const Comparison& comparison = analyses.comparison();
  if (comparison.lines.empty()) return {};
  std::string html = format_paragraph(
      "Only the first crossing of each run is counted. Height is the height of the centre of mass "
      "above the ground; the top adds the distance from the centre of mass to the farthest corner "
      "of the block. Energy is translational plus rotational.");
  const std::size_t draws = draws_of_ground(comparison);
  if (draws > 0) {
    html += format_paragraph(
        "The statistics combine the runs on all " + std::to_string(draws) +
        " draws of the ground parameters; their intervals cover release points only. The ranges at "
        "the top of the report show the effect of the ground parameters.");
  }
  const std::vector<RealisationCrossings>& passages = analyses.barrier_crossings();
  std::string charts, figures;
  for (std::size_t line = 0; line < comparison.lines.size(); ++line) {
    const BarrierLine& barrier = comparison.lines[line];
    const std::vector<const Crossing*> first = find_counted_crossings(comparison, line);
    const bool any = std::any_of(first.begin(), first.end(), [](auto* one) { return one; });
    html += describe_crossings(comparison, passages, line);
    if (any)
      charts += barrier_charts(comparison, line) + draw_crossing_charts(comparison, passages, line);
    else
      figures += format_paragraph("No run crossed " + barrier.name + ".");
    figures += format_folded_section(
        "Statistics at " + barrier.name,
        "<p class=\"note\">" + escape_html(barrier_ends(barrier)) + "; " +
            directions_of(comparison, line) + ".</p>\n" + crossing_table(comparison, line) +
            impact_table(comparison, line) + format_crossing_table(comparison, passages, line),
        PrintedState::kOpen);
  }
  if (!charts.empty()) html += "<div class=\"charts by-three\">\n" + charts + "</div>\n";
  html += figures;
  return format_section("Barriers", html);
}

}  // namespace clast::report_detail
