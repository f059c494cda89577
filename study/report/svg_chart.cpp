#include "study/report/svg_chart.hpp"

#include <algorithm>
#include <cmath>

#include "study/report/html_page.hpp"
#include "study/report/ticks.hpp"

namespace clast {
namespace {

constexpr double kWidth = 520.0, kLeft = 56.0, kRight = 12.0, kTop = 34.0;
constexpr double kPlotWidth = kWidth - kLeft - kRight;
constexpr const char* kGrid = "stroke=\"#e2e6ea\"";
constexpr const char* kAxis = "stroke=\"#5b6775\"";
constexpr const char* kSmall = "font-size=\"12\" fill=\"#33404d\"";
constexpr std::size_t kMostSteps = 1500;  // of a curve; more can't be told apart on paper

struct Range {
  double low = 0.0;
  double high = 1.0;
};

Range range_of(const std::vector<Series>& series) {
  Range range{INFINITY, -INFINITY};
  for (const Series& one : series) {
    for (const double value : one.values) {
      range.low = std::min(range.low, value);
      range.high = std::max(range.high, value);
    }
  }
  if (!(range.low <= range.high)) return {};
  // An axis that nearly reaches zero is read as if it did: let it.
  if (range.low > 0.0 && range.low < 0.5 * range.high) range.low = 0.0;
  // Values that are equal to rounding get a width, so that ticks and bins stay countable.
  const double size = std::max(std::abs(range.low), std::abs(range.high));
  if (range.high - range.low <= 1e-9 * size || range.low == range.high) {
    const double margin = std::max(0.5, 1e-6 * size);
    return {range.low - margin, range.high + margin};
  }
  return range;
}

double x_at(const Range& range, double value) {
  return kLeft + kPlotWidth * (value - range.low) / (range.high - range.low);
}

std::string title_of(const ChartText& text) {
  return svg_text(kLeft, 18, text.title, "font-size=\"14\" font-weight=\"600\" fill=\"#1d2733\"");
}

/// Vertical grid lines over [top, bottom] and numbers with the axis label below.
std::string x_axis(const Range& range, double top, double bottom, const std::string& label) {
  const Ticks marks = ticks(range.low, range.high, 7);
  std::string svg;
  for (const double value : marks.values) {
    const double x = x_at(range, value);
    svg += svg_line(x, top, x, bottom, kGrid);
    svg += svg_text(x, bottom + 16, fixed(value, marks.decimals),
                    std::string(kSmall) + " text-anchor=\"middle\"");
  }
  return svg + svg_text(kLeft + kPlotWidth / 2, bottom + 34, label,
                        std::string(kSmall) + " text-anchor=\"middle\"");
}

std::string name_with_count(const Series& series) {
  return series.name + " (" + std::to_string(series.values.size()) + ")";
}

std::string dash_style(const Series& series) {
  return series.dash.empty() ? "" : " stroke-dasharray=\"" + series.dash + "\"";
}

/// Steps of the cumulative share, in px.
std::string step_path(const Series& series, const Range& range, double top, double height,
                      bool exceeding) {
  std::vector<double> sorted = series.values;
  std::sort(sorted.begin(), sorted.end());
  const std::size_t stride = 1 + sorted.size() / kMostSteps;
  const auto y_at = [&](double share) { return top + height * (exceeding ? share : 1.0 - share); };
  std::string path = "M" + fixed(kLeft, 1) + " " + fixed(y_at(0.0), 1);
  for (std::size_t i = 0; i < sorted.size(); i += stride) {
    const std::size_t upto = std::min(i + stride, sorted.size());
    path += "H" + fixed(x_at(range, sorted[upto - 1]), 1) + "V" +
            fixed(y_at(static_cast<double>(upto) / static_cast<double>(sorted.size())), 1);
  }
  return path + "H" + fixed(kLeft + kPlotWidth, 1);
}

}  // namespace

std::string cumulative_chart(const ChartText& text, const std::vector<Series>& series,
                             bool exceeding) {
  constexpr double kHeight = 210.0, kLegendRow = 18.0;
  std::vector<const Series*> drawn;
  for (const Series& one : series) {
    if (!one.values.empty()) drawn.push_back(&one);
  }
  const double legend_rows = std::ceil(static_cast<double>(drawn.size()) / 2.0);
  const double bottom = kTop + kHeight;
  std::string svg = svg_open(kWidth, bottom + 46 + kLegendRow * legend_rows, text.title);
  svg += title_of(text);
  const Range range = range_of(series);
  svg += x_axis(range, kTop, bottom, text.x_label);
  for (int k = 0; k <= 4; ++k) {
    const double y = bottom - kHeight * k / 4.0;
    svg += svg_line(kLeft, y, kWidth - kRight, y, kGrid);
    svg += svg_text(kLeft - 6, y + 4, std::to_string(25 * k) + " %",
                    std::string(kSmall) + " text-anchor=\"end\"");
  }
  svg += svg_line(kLeft, bottom, kWidth - kRight, bottom, kAxis);
  for (std::size_t i = 0; i < drawn.size(); ++i) {
    const Series& one = *drawn[i];
    const std::string pen = "stroke=\"" + one.colour + "\" stroke-width=\"2\"" + dash_style(one);
    svg += "<path fill=\"none\" " + pen + " d=\"" +
           step_path(one, range, kTop, kHeight, exceeding) + "\"><title>" +
           escaped(name_with_count(one)) + "</title></path>";
    const double x = kLeft + kPlotWidth / 2 * static_cast<double>(i % 2);
    const double y = bottom + 54 + kLegendRow * static_cast<double>(i / 2);
    svg += svg_line(x, y - 4, x + 24, y - 4, pen);
    svg += svg_text(x + 30, y, name_with_count(one), kSmall);
  }
  return svg + "</svg>\n";
}

std::string histogram_chart(const ChartText& text, const std::vector<Series>& series) {
  constexpr double kRow = 92.0, kGap = 24.0;
  const Range data = range_of(series);
  const double bin = round_up_to_nice((data.high - data.low) / 24.0);
  const Range range{std::floor(data.low / bin) * bin, (std::floor(data.high / bin) + 1.0) * bin};
  const std::size_t bins = static_cast<std::size_t>(std::lround((range.high - range.low) / bin));

  std::vector<std::vector<double>> shares;
  double highest = 0.0;
  for (const Series& one : series) {
    std::vector<double> share(bins, 0.0);
    for (const double value : one.values) {
      const double place = std::floor((value - range.low) / bin);
      share[std::min(static_cast<std::size_t>(std::max(place, 0.0)), bins - 1)] +=
          1.0 / static_cast<double>(one.values.size());
    }
    highest = std::max(highest, *std::max_element(share.begin(), share.end()));
    shares.push_back(std::move(share));
  }
  if (highest == 0.0) highest = 1.0;

  const double bottom = kTop + static_cast<double>(series.size()) * (kRow + kGap);
  std::string svg = svg_open(kWidth, bottom + 46, text.title) + title_of(text);
  svg += x_axis(range, kTop, bottom, text.x_label);
  const Ticks levels = ticks(0.0, 100.0 * highest, 3);
  for (std::size_t i = 0; i < series.size(); ++i) {
    const double base = kTop + static_cast<double>(i + 1) * (kRow + kGap);
    for (const double level : levels.values) {
      const double y = base - kRow * level / (100.0 * highest);
      if (level > 0.0) svg += svg_line(kLeft, y, kWidth - kRight, y, kGrid);
      svg += svg_text(kLeft - 6, y + 4, fixed(level, levels.decimals) + " %",
                      std::string(kSmall) + " text-anchor=\"end\"");
    }
    for (std::size_t k = 0; k < bins; ++k) {
      if (shares[i][k] == 0.0) continue;
      const double low = range.low + bin * static_cast<double>(k);
      const double x = x_at(range, low), width = x_at(range, low + bin) - x;
      const double height = kRow * shares[i][k] / highest;
      svg += "<rect x=\"" + fixed(x + 0.5, 1) + "\" y=\"" + fixed(base - height, 1) +
             "\" width=\"" + fixed(width - 1.0, 1) + "\" height=\"" + fixed(height, 1) +
             "\" fill=\"" + series[i].colour + "\"><title>" +
             escaped(significant(low, 4) + " to " + significant(low + bin, 4) + ": " +
                     percent(shares[i][k])) +
             "</title></rect>";
    }
    svg += svg_line(kLeft, base, kWidth - kRight, base, kAxis);
    svg += svg_text(kWidth - kRight, base - kRow + 2, name_with_count(series[i]),
                    std::string(kSmall) +
                        " font-weight=\"600\" text-anchor=\"end\" stroke=\"#fff\" "
                        "stroke-width=\"3\" paint-order=\"stroke\"");
  }
  return svg + "</svg>\n";
}

}  // namespace clast
