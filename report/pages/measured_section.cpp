#include "core/number_text.hpp"
#include "report/charts/palette.hpp"
#include "report/charts/plotly_chart.hpp"
#include "report/html/html_page.hpp"
#include "report/pages/report_sections.hpp"
#include "report/text/measured_text.hpp"

namespace clast::report_detail {
namespace {

constexpr const char* kSimulatedColour = kDataColours[0];
constexpr const char* kFieldColour = kDataColours[3];

/// A curve over its band, if it has one.
void add_curve(const RunoutDistributionCurve& curve, const std::string& name,
               const std::string& colour, const std::string& dash,
               std::vector<ChartTrace>& traces) {
  if (!curve.low.empty()) {
    ChartTrace low{name, colour, "", ChartTrace::Kind::kSteps, curve.runout, curve.low};
    low.named = false;
    ChartTrace high{name, colour, "", ChartTrace::Kind::kSteps, curve.runout, curve.high};
    high.named = false;
    high.filled = true;
    traces.push_back(std::move(low));
    traces.push_back(std::move(high));
  }
  traces.push_back({name, colour, dash, ChartTrace::Kind::kSteps, curve.runout, curve.fraction});
}

std::string group_title(const RunGroup& group) {
  return group.kind == RunGroupKind::kAll      ? "All blocks"
         : group.kind == RunGroupKind::kGarcia ? group.key + " blocks"
                                               : "Block " + group.key;
}

std::string measured_table(const Comparison& comparison) {
  HtmlTable table(
      {"group", "measured", "simulated", "measured runout mean, m", "simulated runout mean, m",
       "measured median, m", "simulated median, m", "difference of medians, m", "95 % from",
       "95 % to", "Cliff's delta", "KS distance", "p (Holm)"},
      1);
  for (const MeasuredStopGroup& group : comparison.measured->groups) {
    const std::optional<Interval>& interval = group.medians.interval;
    table.row(
        {comparison.groups[group.group].name, std::to_string(group.measured),
         std::to_string(group.simulated), format_fixed(group.runout.mean, 1),
         format_fixed(group.simulated_runout, 1), format_fixed(group.quartiles.median, 1),
         format_fixed(group.simulated_quartiles.median, 1), format_fixed(group.medians.estimate, 1),
         interval ? format_fixed(interval->low, 1) : "-",
         interval ? format_fixed(interval->high, 1) : "-",
         format_significant(group.cliffs_delta, 3), format_significant(group.ks_distance, 3),
         group.medians.holm_p_value ? format_significant(*group.medians.holm_p_value, 2) : "-"});
  }
  return table.html();
}

}  // namespace

std::string format_measured_section(const Comparison& comparison) {
  if (!comparison.measured) return "";
  const std::string title = "Measured against simulated";
  if (comparison.measured->groups.empty()) {
    return format_section(
        title, format_paragraph(
                   "No simulated run came to rest, so the measured stops cannot be compared."));
  }
  std::string html;
  for (const std::string& sentence : describe_measured_stops(comparison)) {
    html += "<p class=\"verdict\">" + escape_html(sentence) + "</p>\n";
  }
  html += "<div class=\"charts\">\n";
  for (const MeasuredStopGroup& group : comparison.measured->groups) {
    std::vector<ChartTrace> traces;
    add_curve(group.simulated_curve, "simulated (" + std::to_string(group.simulated) + ")",
              kSimulatedColour, "", traces);
    add_curve(group.curve, "measured (" + std::to_string(group.measured) + ")", kFieldColour, "6 3",
              traces);
    html += draw_plotly_chart(
        {group_title(comparison.groups[group.group]) + ": fraction that stops before a runout",
         "runout, m", "fraction of stops", true},
        traces);
  }
  html += "</div>\n" + format_paragraph("The bands are the 95 % intervals of the curves.");
  return format_section(
      title, html + format_folded_section("Statistics and tests", measured_table(comparison)));
}

}  // namespace clast::report_detail
