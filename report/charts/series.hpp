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
  std::vector<double> weights =
      {};  ///< one per value, for cumulative charts; if empty, weights are equal
  std::vector<std::string> names = {};   ///< one per value, shown as tooltip
  std::vector<std::string> blocks = {};  ///< data-block of each mark (see `make_report_page`)
};

}  // namespace clast::report_detail
