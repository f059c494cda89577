#pragma once
/// Distribution charts as SVG.
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "report/charts/series.hpp"

namespace clast::report_detail {

/// A smooth curve over a cumulative chart: shares in [0, 1] at rising x.
struct Curve {
  std::string name;
  std::string colour;
  std::string dash;
  std::vector<std::pair<double, double>> points;
};

/// A vertical line with a word beside it.
struct Limit {
  double value = 0.0;
  std::string text;
};

struct ChartText {
  std::string title;
  std::string x_label;
  bool logarithmic = false;  ///< x, of a cumulative chart; values are positive
  std::vector<Limit> limits = {};
};

/// Marks and names are drawn up to so many values per series: more would hide the curve.
inline constexpr std::size_t kMostNamedMarks = 500;

/// Share of each sample at or below x, as steps. Where values have names, each gets a mark that
/// shows it.
std::string cumulative_chart(const ChartText& text, const std::vector<Series>& series,
                             const std::vector<Curve>& curves = {});

/// One row of bars per sample over common bins, each in per cent of its sample. A value on the edge
/// of a bin is in the bin below; limits are edges where that takes no more than sixty bins.
std::string draw_histogram(const ChartText& text, const std::vector<Series>& series);

}  // namespace clast::report_detail
