#include "report/charts/svg_chart.hpp"

#include <algorithm>
#include <cmath>

#include "report/charts/bins.hpp"
#include "report/charts/ticks.hpp"
#include "report/html/html_page.hpp"

namespace clast::report_detail {
namespace {

constexpr double kChartWidth = 520.0, kChartLeft = 56.0, kChartRight = 12.0, kChartTop = 34.0;
constexpr double kPlotWidth = kChartWidth - kChartLeft - kChartRight;
constexpr const char* kGrid = "stroke=\"#e2e6ea\"";
constexpr const char* kAxis = "stroke=\"#5b6775\"";
constexpr const char* kChartText = "font-size=\"12\" fill=\"#33404d\"";
constexpr const char* kChartHalo = " stroke=\"#fff\" stroke-width=\"3\" paint-order=\"stroke\"";
constexpr double kLegendRow = 18.0;
constexpr std::size_t kMaxPrintedSteps = 1500;  // of a curve; more can't be distinguished on paper

struct AxisRange {
  double low = 0.0;
  double high = 1.0;
  bool logarithmic = false;
};

AxisRange axis_range(const std::vector<ChartSeries>& series, bool logarithmic = false) {
  AxisRange range{INFINITY, -INFINITY};
  for (const ChartSeries& one : series) {
    for (const double value : one.values) {
      range.low = std::min(range.low, value);
      range.high = std::max(range.high, value);
    }
  }
  if (logarithmic && range.low <= range.high) {
    // A tenth of the width on either side, and room where all values are equal.
    const double margin = std::max(1.08, std::pow(range.high / range.low, 0.1));
    return {range.low / margin, range.high * margin, true};
  }
  const AxisInterval span = nice_axis_range(range.low, range.high);
  return {span.low, span.high};
}

double x_at(const AxisRange& range, double value) {
  const double share = range.logarithmic
                           ? std::log(value / range.low) / std::log(range.high / range.low)
                           : (value - range.low) / (range.high - range.low);
  return kChartLeft + kPlotWidth * share;
}

/// Ticks of the axis as numbers and their text.
std::vector<std::pair<double, std::string>> x_ticks(const AxisRange& range) {
  std::vector<std::pair<double, std::string>> marks;
  if (range.logarithmic) {
    for (const double value : choose_log_ticks(range.low, range.high, 9)) {
      marks.emplace_back(value, format_significant_digits(value, 1));
    }
    if (marks.size() >= 3) return marks;
    marks.clear();  // less than a decade: round steps read better
  }
  const AxisTicks found = choose_ticks(range.low, range.high, 7);
  for (const double value : found.values)
    marks.emplace_back(value, format_fixed(value, found.decimals));
  return marks;
}

std::string chart_title(const ChartLabels& text) {
  return svg_text(kChartLeft, 18, text.title,
                  "font-size=\"14\" font-weight=\"600\" fill=\"#1d2733\"");
}

/// Vertical grid lines over [top, bottom] and numbers with the axis label below.
std::string x_axis(const AxisRange& range, double top, double bottom, const std::string& label) {
  std::string svg;
  for (const auto& [value, text] : x_ticks(range)) {
    const double x = x_at(range, value);
    svg += format_svg_line(x, top, x, bottom, kGrid);
    svg += svg_text(x, bottom + 16, text, std::string(kChartText) + " text-anchor=\"middle\"");
  }
  return svg + svg_text(kChartLeft + kPlotWidth / 2, bottom + 34, label,
                        std::string(kChartText) + " text-anchor=\"middle\"");
}

// Limit for half of the chart's width.
constexpr std::size_t kMaxTitleCharacters = 24;

std::string name_with_count(const ChartSeries& series) {
  return shorten_text(series.name, kMaxTitleCharacters) + " (" +
         std::to_string(series.values.size()) + ")";
}

std::string dash_style(const std::string& dash) {
  return dash.empty() ? "" : " stroke-dasharray=\"" + dash + "\"";
}

/// Limits that lie in the range, dashed, with their words at the top.
std::string limit_lines(const ChartLabels& text, const AxisRange& range, double top,
                        double bottom) {
  std::string svg;
  for (const LimitLine& limit : text.limits) {
    if (limit.value < range.low || limit.value > range.high) continue;
    const double x = x_at(range, limit.value);
    const bool right = x > kChartLeft + 0.6 * kPlotWidth;  // no room on that side for words
    svg += format_svg_line(x, top, x, bottom, "stroke=\"#1d2733\" stroke-dasharray=\"5 4\"");
    svg += svg_text(x + (right ? -5 : 5), top + 11, limit.text,
                    std::string(kChartText) + (right ? " text-anchor=\"end\"" : "") + kChartHalo);
  }
  return svg;
}

struct Step {
  double value;
  double share;       ///< up to and with it
  std::size_t index;  ///< of the value in its series
};

/// Values in ascending order with their cumulative shares.
std::vector<Step> steps_of(const ChartSeries& series) {
  std::vector<Step> steps;
  double total = 0.0;
  for (std::size_t i = 0; i < series.values.size(); ++i) {
    steps.push_back({series.values[i], 0.0, i});
    total += series.weights.empty() ? 1.0 : series.weights[i];
  }
  std::stable_sort(steps.begin(), steps.end(),
                   [](const Step& a, const Step& b) { return a.value < b.value; });
  double sum = 0.0;
  for (Step& step : steps) {
    sum += series.weights.empty() ? 1.0 : series.weights[step.index];
    step.share = sum / total;
  }
  return steps;
}

/// The curve of a sample, in px.
std::string step_path(const std::vector<Step>& steps, const AxisRange& range, double top,
                      double height) {
  const std::size_t stride = 1 + steps.size() / kMaxPrintedSteps;
  const auto y_at = [&](double share) { return top + height * (1.0 - share); };
  std::string path = "M" + format_fixed(kChartLeft, 1) + " " + format_fixed(y_at(0.0), 1);
  for (std::size_t i = 0; i < steps.size(); i += stride) {
    const Step& last = steps[std::min(i + stride, steps.size()) - 1];
    path +=
        "H" + format_fixed(x_at(range, last.value), 1) + "V" + format_fixed(y_at(last.share), 1);
  }
  return path + "H" + format_fixed(kChartLeft + kPlotWidth, 1);
}

std::string named_marks(const ChartSeries& series, const std::vector<Step>& steps,
                        const AxisRange& range, double top, double height) {
  if (series.names.empty() || series.names.size() > kMaxNamedMarks) return {};
  std::string svg;
  for (const Step& step : steps) {
    const std::string& block = series.blocks.empty() ? std::string() : series.blocks[step.index];
    svg += "<circle class=\"block\"" + (block.empty() ? "" : " data-block=\"" + block + "\"") +
           " cx=\"" + format_fixed(x_at(range, step.value), 1) + "\" cy=\"" +
           format_fixed(top + height * (1.0 - step.share), 1) + "\" r=\"2.6\" fill=\"" +
           series.colour + "\"><title>" +
           escape_html(series.names[step.index] + "\n" + format_percent(step.share) +
                       " up to here, " + series.name) +
           "</title></circle>\n";
  }
  return svg;
}

std::string smooth_path(const ChartCurve& curve, const AxisRange& range, double top,
                        double height) {
  std::string path;
  for (const auto& [x, share] : curve.points) {
    if (x < range.low || x > range.high) continue;
    path += (path.empty() ? "M" : "L") + format_fixed(x_at(range, x), 1) + " " +
            format_fixed(top + height * (1.0 - share), 1);
  }
  return path;
}

/// One line of the legend below a chart.
struct LegendEntry {
  std::string name;
  std::string pen;
};

std::string legend_below(const std::vector<LegendEntry>& entries, double top) {
  std::string svg;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const double x = kChartLeft + kPlotWidth / 2 * static_cast<double>(i % 2);
    const double y = top + kLegendRow * static_cast<double>(i / 2);
    svg += format_svg_line(x, y - 4, x + 24, y - 4, entries[i].pen);
    svg += svg_text(x + 30, y, entries[i].name, kChartText);
  }
  return svg;
}

/// Up to five names of what lies in a bin.
std::string names_in_bin(const std::vector<std::string>& names) {
  constexpr std::size_t kMaxNames = 5;
  std::string text;
  for (std::size_t i = 0; i < std::min(names.size(), kMaxNames); ++i) text += "\n" + names[i];
  if (names.size() > kMaxNames) {
    text += "\nand " + std::to_string(names.size() - kMaxNames) + " more";
  }
  return text;
}

}  // namespace

std::string draw_cumulative_chart(const ChartLabels& text, const std::vector<ChartSeries>& series,
                                  const std::vector<ChartCurve>& curves) {
  constexpr double kHeight = 210.0;
  std::vector<LegendEntry> entries;
  for (const ChartSeries& one : series) {
    if (one.values.empty()) continue;
    entries.push_back({name_with_count(one),
                       "stroke=\"" + one.colour + "\" stroke-width=\"2\"" + dash_style(one.dash)});
  }
  const std::size_t samples = entries.size();
  for (const ChartCurve& curve : curves) {
    entries.push_back({curve.name, "stroke=\"" + curve.colour + "\" stroke-width=\"1.6\"" +
                                       dash_style(curve.dash)});
  }
  const double legend_rows = std::ceil(static_cast<double>(entries.size()) / 2.0);
  const double bottom = kChartTop + kHeight;
  std::string svg = open_svg(kChartWidth, bottom + 46 + kLegendRow * legend_rows, text.title);
  svg += chart_title(text);
  const AxisRange range = axis_range(series, text.logarithmic);
  svg += x_axis(range, kChartTop, bottom, text.x_label);
  for (int k = 0; k <= 4; ++k) {
    const double y = bottom - kHeight * k / 4.0;
    svg += format_svg_line(kChartLeft, y, kChartWidth - kChartRight, y, kGrid);
    svg += svg_text(kChartLeft - 6, y + 4, std::to_string(25 * k) + " %",
                    std::string(kChartText) + " text-anchor=\"end\"");
  }
  svg += format_svg_line(kChartLeft, bottom, kChartWidth - kChartRight, bottom, kAxis);
  for (std::size_t i = 0; i < curves.size(); ++i) {
    svg += "<path fill=\"none\" " + entries[samples + i].pen + " d=\"" +
           smooth_path(curves[i], range, kChartTop, kHeight) + "\"><title>" +
           escape_html(curves[i].name) + "</title></path>";
  }
  std::size_t entry = 0;
  for (const ChartSeries& one : series) {
    if (one.values.empty()) continue;
    const std::vector<Step> steps = steps_of(one);
    svg += "<path fill=\"none\" " + entries[entry].pen + " d=\"" +
           step_path(steps, range, kChartTop, kHeight) + "\"><title>" +
           escape_html(entries[entry].name) + "</title></path>" +
           named_marks(one, steps, range, kChartTop, kHeight);
    ++entry;
  }
  svg += limit_lines(text, range, kChartTop, bottom);
  return svg + legend_below(entries, bottom + 54) + "</svg>\n";
}

std::string draw_histogram(const ChartLabels& text, const std::vector<ChartSeries>& series) {
  constexpr double kRow = 92.0, kGap = 24.0;
  const AxisRange data = axis_range(series);
  std::vector<double> limits;
  for (const LimitLine& limit : text.limits) limits.push_back(limit.value);
  const Bins bins = choose_bins({data.low, data.high}, limits);
  const AxisRange range{bins.low, bins.low + bins.width * static_cast<double>(bins.count)};

  std::vector<std::vector<double>> shares;
  std::vector<std::vector<std::vector<std::string>>> names;  // by series and bin
  double highest = 0.0;
  for (const ChartSeries& one : series) {
    std::vector<double> share(bins.count, 0.0);
    names.emplace_back(bins.count);
    for (std::size_t i = 0; i < one.values.size(); ++i) {
      const std::size_t k = bins.bin_index(one.values[i]);
      share[k] += 1.0 / static_cast<double>(one.values.size());
      if (!one.names.empty()) names.back()[k].push_back(one.names[i]);
    }
    highest = std::max(highest, *std::max_element(share.begin(), share.end()));
    shares.push_back(std::move(share));
  }
  if (highest == 0.0) highest = 1.0;

  const double bottom = kChartTop + static_cast<double>(series.size()) * (kRow + kGap);
  std::string svg = open_svg(kChartWidth, bottom + 46, text.title) + chart_title(text);
  svg += x_axis(range, kChartTop, bottom, text.x_label);
  const AxisTicks levels = choose_ticks(0.0, 100.0 * highest, 3);
  for (std::size_t i = 0; i < series.size(); ++i) {
    const double base = kChartTop + static_cast<double>(i + 1) * (kRow + kGap);
    for (const double level : levels.values) {
      const double y = base - kRow * level / (100.0 * highest);
      if (level > 0.0) svg += format_svg_line(kChartLeft, y, kChartWidth - kChartRight, y, kGrid);
      svg += svg_text(kChartLeft - 6, y + 4, format_fixed(level, levels.decimals) + " %",
                      std::string(kChartText) + " text-anchor=\"end\"");
    }
    for (std::size_t k = 0; k < bins.count; ++k) {
      if (shares[i][k] == 0.0) continue;
      const double low = range.low + bins.width * static_cast<double>(k);
      const double x = x_at(range, low), width = x_at(range, low + bins.width) - x;
      const double height = kRow * shares[i][k] / highest;
      svg += "<rect x=\"" + format_fixed(x + 0.5, 1) + "\" y=\"" + format_fixed(base - height, 1) +
             "\" width=\"" + format_fixed(width - 1.0, 1) + "\" height=\"" +
             format_fixed(height, 1) + "\" fill=\"" + series[i].colour + "\"><title>" +
             escape_html(format_significant_digits(low, 4) + " to " +
                         format_significant_digits(low + bins.width, 4) + ": " +
                         format_percent(shares[i][k]) + names_in_bin(names[i][k])) +
             "</title></rect>";
    }
    svg += format_svg_line(kChartLeft, base, kChartWidth - kChartRight, base, kAxis);
    svg +=
        svg_text(kChartWidth - kChartRight, base - kRow + 2, name_with_count(series[i]),
                 std::string(kChartText) + " font-weight=\"600\" text-anchor=\"end\"" + kChartHalo);
  }
  return svg + limit_lines(text, range, kChartTop, bottom) + "</svg>\n";
}

}  // namespace clast::report_detail
