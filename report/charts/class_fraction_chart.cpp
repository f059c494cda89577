#include "report/charts/class_fraction_chart.hpp"

#include <algorithm>

#include "report/charts/ticks.hpp"
#include "report/html/html_page.hpp"

namespace clast::report_detail {
namespace {

constexpr double kBarsWidth = 520.0, kBarsRight = 64.0, kBarsTop = 34.0, kBar = 11.0, kGap = 9.0;
constexpr double kCharacter = 6.6;  // px, of a name at the font size below
constexpr const char* kBarText = "font-size=\"12\" fill=\"#33404d\"";

struct BarLegend {
  std::string svg;
  double bottom = 0.0;
};

/// Draws the legend of colours and whiskers, in as many rows as needed from `top` on.
BarLegend legend_from(const std::vector<ClassFractionSeries>& series, double top) {
  constexpr std::size_t kMaxCharacters = 64;
  constexpr double kRow = 20.0;
  std::string svg;
  double x = 8.0;
  const auto place = [&](double width) {
    if (x > 8.0 && x + width > kBarsWidth - 8.0) {
      x = 8.0;
      top += kRow;
    }
  };
  for (const ClassFractionSeries& one : series) {
    const std::string name = shorten_text(one.name, kMaxCharacters);
    const double width = 18.0 + kCharacter * static_cast<double>(name.size());
    place(width);
    svg += "<rect x=\"" + format_fixed(x, 1) + "\" y=\"" + format_fixed(top, 1) +
           "\" width=\"12\" height=\"12\" fill=\"" + one.colour + "\" fill-opacity=\".75\"/>" +
           svg_text(x + 18, top + 10, name, kBarText);
    x += width + 16.0;
  }
  const std::string whiskers = "whiskers: 95 % interval";
  place(kCharacter * static_cast<double>(whiskers.size()));
  svg += svg_text(x, top + 10, whiskers, kBarText);
  return {svg, top + kRow};
}

}  // namespace

std::string draw_class_fractions(const std::string& title, const std::vector<std::string>& classes,
                                 const std::vector<ClassFractionSeries>& series) {
  std::size_t longest = 4;
  for (const std::string& name : classes) longest = std::max(longest, name.size());
  const double left = std::min(250.0, 16.0 + kCharacter * static_cast<double>(longest));
  double highest = 0.0;
  for (const ClassFractionSeries& one : series) {
    for (const FractionWithInterval& share : one.shares) highest = std::max(highest, share.high);
  }
  const AxisTicks marks = choose_ticks(0.0, 100.0 * std::max(highest, 0.01), 5);
  const double scale =
      (kBarsWidth - left - kBarsRight) / (100.0 * std::max(highest, 0.01));  // px per %
  const double row = kBar * static_cast<double>(series.size()) + kGap;
  const double bottom = kBarsTop + row * static_cast<double>(classes.size());
  const BarLegend legend = legend_from(series, bottom + 40);

  std::string svg = open_svg(kBarsWidth, legend.bottom + 4, title) +
                    svg_text(8, 18, title, "font-size=\"14\" font-weight=\"600\" fill=\"#1d2733\"");
  for (const double value : marks.values) {
    const double x = left + scale * value;
    svg += format_svg_line(x, kBarsTop, x, bottom,
                           value == 0.0 ? "stroke=\"#5b6775\"" : "stroke=\"#e2e6ea\"");
    svg += svg_text(x, bottom + 16, format_fixed(value, marks.decimals) + " %",
                    std::string(kBarText) + " text-anchor=\"middle\"");
  }
  for (std::size_t k = 0; k < classes.size(); ++k) {
    const double top = kBarsTop + row * static_cast<double>(k) + 0.5 * kGap;
    svg += svg_text(left - 8, top + 0.5 * (row - kGap) + 4, classes[k],
                    std::string(kBarText) + " text-anchor=\"end\"");
    for (std::size_t i = 0; i < series.size(); ++i) {
      const FractionWithInterval& share = series[i].shares[k];
      const double y = top + kBar * static_cast<double>(i), middle = y + 0.5 * kBar;
      const double low = left + scale * 100.0 * share.low, high = left + scale * 100.0 * share.high;
      svg += "<g><title>" + escape_html(classes[k] + ", " + series[i].name + ": " + share.note) +
             "</title><rect x=\"" + format_fixed(left, 1) + "\" y=\"" + format_fixed(y + 1, 1) +
             "\" width=\"" + format_fixed(scale * 100.0 * share.value, 1) + "\" height=\"" +
             format_fixed(kBar - 2.0, 1) + "\" fill=\"" + series[i].colour +
             "\" fill-opacity=\".75\"/>" +
             format_svg_line(low, middle, high, middle, "stroke=\"#1d2733\" stroke-width=\"1.3\"") +
             format_svg_line(low, middle - 3, low, middle + 3, "stroke=\"#1d2733\"") +
             format_svg_line(high, middle - 3, high, middle + 3, "stroke=\"#1d2733\"") +
             svg_text(high + 6, middle + 4, format_percent(share.value),
                      "font-size=\"11\" fill=\"#33404d\"") +
             "</g>\n";
    }
  }
  return svg + legend.svg + "</svg>\n";
}

}  // namespace clast::report_detail
