#pragma once
/// Distribution charts as SVG.
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace clast {

/// One sample to draw.
struct Series {
  std::string name;
  std::string colour;  ///< "#rrggbb"
  std::string dash;    ///< SVG dash pattern; empty for a full line
  std::vector<double> values;
  std::vector<double> weights = {};      ///< of each value in a cumulative chart; empty: all alike
  std::vector<std::string> names = {};   ///< of each value, said by the mark or bar that holds it
  std::vector<std::string> blocks = {};  ///< data-block of each mark, see `page`
};

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

/// Share of each sample at or below x, as steps; with `exceeding`, the share above x. Where values
/// have names, each gets a mark that says it.
std::string cumulative_chart(const ChartText& text, const std::vector<Series>& series,
                             bool exceeding = false, const std::vector<Curve>& curves = {});

/// One row of bars per sample over common bins, each in per cent of its sample. A value on the edge
/// of a bin is in the bin below; limits are edges where that takes no more than sixty bins.
std::string histogram_chart(const ChartText& text, const std::vector<Series>& series);

}  // namespace clast
