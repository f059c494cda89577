#pragma once
/// Distribution charts (SVG).
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "report/charts/series.hpp"

namespace clast::report_detail {

/// Smooth curve in a cumulative chart: fractions in [0, 1] at ascending x.
struct ChartCurve {
  std::string name;
  std::string colour;
  std::string dash;
  std::vector<std::pair<double, double>> points;
};

/// Vertical line with a label.
struct LimitLine {
  double value = 0.0;
  std::string text;
};

struct ChartLabels {
  std::string title;
  std::string x_label;
  bool logarithmic = false;  ///< true if the x axis of a cumulative chart is logarithmic
  std::vector<LimitLine> limits = {};
};

/// Maximum number of named marks per series.
inline constexpr std::size_t kMaxNamedMarks = 500;

/// Draws cumulative distributions as step curves. Named values have a mark with a tooltip.
std::string draw_cumulative_chart(const ChartLabels& text, const std::vector<ChartSeries>& series,
                                  const std::vector<ChartCurve>& curves = {});

/// Draws one histogram per sample, in per cent. All samples have the same bins.
std::string draw_histogram(const ChartLabels& text, const std::vector<ChartSeries>& series);

}  // namespace clast::report_detail
