#pragma once
/// Samples drawn by distribution charts.
#include <string>
#include <vector>

namespace clast::report_detail {

struct ChartSeries {
  std::string name;
  std::string colour;  ///< "#rrggbb"
  std::string dash;    ///< SVG dash pattern; empty for a solid line
  std::vector<double> values;
  /// Weight of each value in cumulative charts; if empty, weights are equal.
  std::vector<double> weights = {};
  std::vector<std::string> names = {};  ///< tooltip of each value
  /// Identifier of each block, for highlighting in all diagrams.
  std::vector<std::string> blocks = {};
};

}  // namespace clast::report_detail
