#include "report/charts/marks.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "report/charts/palette.hpp"
#include "report/html/html_page.hpp"

namespace clast::report_detail {

std::string draw_shape_mark(double x, double y, const std::string& garcia, bool filled,
                            const std::string& attributes, const std::string& title) {
  const std::string paint = filled ? "fill=\"" + class_colour(garcia) +
                                         "\" fill-opacity=\".8\" stroke=\"#fff\" "
                                         "stroke-width=\".7\""
                                   : "fill=\"#fff\" fill-opacity=\".6\" stroke-width=\"1.6\" "
                                     "stroke=\"" +
                                         class_colour(garcia) + "\"";
  const std::string tail = title.empty() ? "/>" : "><title>" + escape_html(title) + "</title>";
  if (garcia == "compact") {
    return "<circle " + attributes + " cx=\"" + format_fixed(x, 1) + "\" cy=\"" +
           format_fixed(y, 1) + "\" r=\"3.6\" " + paint + tail + (title.empty() ? "" : "</circle>");
  }
  return "<path " + attributes + " d=\"M" + format_fixed(x, 1) + " " + format_fixed(y - 4.8, 1) +
         "l4.8 4.8-4.8 4.8-4.8-4.8z\" " + paint + tail + (title.empty() ? "" : "</path>");
}

std::string draw_density_squares(std::span<const Vec2> places, const Vec2& corner,
                                 const std::string& noun) {
  constexpr double kCell = 7.0;  // px
  std::map<std::pair<int, int>, std::size_t> counts;
  std::size_t maximum = 1;
  for (const Vec2& place : places) {
    const int i = static_cast<int>(std::floor((place.x() - corner.x()) / kCell));
    const int j = static_cast<int>(std::floor((place.y() - corner.y()) / kCell));
    maximum = std::max(maximum, ++counts[{i, j}]);
  }
  std::string svg;
  for (const auto& [cell, count] : counts) {
    const double level = std::log(static_cast<double>(count)) /
                         std::log(static_cast<double>(maximum) + 1.0) *
                         static_cast<double>(kDensityColours.size());
    svg += "<rect x=\"" + format_fixed(corner.x() + kCell * cell.first, 1) + "\" y=\"" +
           format_fixed(corner.y() + kCell * cell.second, 1) +
           "\" width=\"7\" height=\"7\" fill=\"" +
           kDensityColours[std::min(static_cast<std::size_t>(level), kDensityColours.size() - 1)] +
           "\" fill-opacity=\".85\"><title>" + std::to_string(count) + " " + escape_html(noun) +
           "</title></rect>";
  }
  return svg;
}

}  // namespace clast::report_detail
