#pragma once
/// What charts of distributions draw.
#include <string>
#include <vector>

namespace clast::report_detail {

/// One sample to draw.
struct Series {
  std::string name;
  std::string colour;  ///< "#rrggbb"
  std::string dash;    ///< SVG dash pattern; empty for a full line
  std::vector<double> values;
  std::vector<double> weights = {};      ///< of each value in a cumulative chart; empty: all alike
  std::vector<std::string> names = {};   ///< of each value, shown by the mark or bar that holds it
  std::vector<std::string> blocks = {};  ///< data-block of each mark, see `make_report_page`
};

}  // namespace clast::report_detail
