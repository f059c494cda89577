#pragma once
/// Distribution charts as SVG.
#include <string>
#include <vector>

namespace clast {

/// One sample to draw.
struct Series {
  std::string name;
  std::string colour;  ///< "#rrggbb"
  std::string dash;    ///< SVG dash pattern; empty for a full line
  std::vector<double> values;
};

struct ChartText {
  std::string title;
  std::string x_label;
};

/// Share of each sample at or below x, as steps; with `exceeding`, the share above x.
std::string cumulative_chart(const ChartText& text, const std::vector<Series>& series,
                             bool exceeding = false);

/// One row of bars per sample over common bins, each in per cent of its sample.
std::string histogram_chart(const ChartText& text, const std::vector<Series>& series);

}  // namespace clast
