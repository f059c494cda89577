#pragma once
/// Distribution charts (SVG).
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "report/charts/series.hpp"

namespace clast::report_detail {

/// Smooth curve over a cumulative chart: fractions in [0, 1] at ascending x.
struct Curve {
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

struct ChartText {
  std::string title;
  std::string x_label;
  bool logarithmic = false;  ///< logarithmic x axis of a cumulative chart; values must be positive
  std::vector<LimitLine> limits = {};
};

/// Maximum number of named marks per series.
inline constexpr std::size_t kMaxNamedMarks = 500;

/// Draws cumulative step curves. Named values have a mark with a tooltip.
std::string draw_cumulative_chart(const ChartText& text, const std::vector<Series>& series,
                                  const std::vector<Curve>& curves = {});

/// Draws one row of bars per sample over common bins, in per cent. A value on an edge belongs to
/// the bin below; limits are edges if at most 60 bins suffice.
std::string draw_histogram(const ChartText& text, const std::vector<Series>& series);

}  // namespace clast::report_detail
