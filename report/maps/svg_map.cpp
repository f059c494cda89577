#include "report/maps/svg_map.hpp"

#include <algorithm>
#include <cmath>

#include "core/nice_number.hpp"
#include "report/charts/ticks.hpp"
#include "report/html/html_page.hpp"
#include "report/maps/map_legend.hpp"
#include "report/maps/map_marks.hpp"

namespace clast {

using namespace report_detail;
namespace {

constexpr double kBelow = 44.0;
constexpr double kLongest = 790.0, kTallest = 640.0;  // of the map itself, px
constexpr double kLegendWidth = 224.0;
constexpr const char* kMapHalo =
    "font-size=\"12.5\" font-weight=\"600\" fill=\"#111\" stroke=\"#fff\" stroke-width=\"3\" "
    "paint-order=\"stroke\"";

std::string axes(const MapToPixels& sheet) {
  const double right = kMapLeft + sheet.width(), bottom = kMapTop + sheet.height();
  std::string svg;
  const AxisTicks xs = choose_ticks(sheet.window.low.x(), sheet.window.high.x(),
                                    std::max(2, static_cast<int>(sheet.width() / 95.0)));
  for (const double value : xs.values) {
    const double x = sheet.x(value);
    svg += format_svg_line(x, kMapTop, x, bottom, "stroke=\"#fff\" stroke-opacity=\".45\"");
    svg += format_svg_line(x, bottom, x, bottom + 5, "stroke=\"#33404d\"");
    svg += svg_text(x, bottom + 18, format_fixed(value, xs.decimals),
                    std::string(kMapTextStyle) + " text-anchor=\"middle\"");
  }
  const AxisTicks ys = choose_ticks(sheet.window.low.y(), sheet.window.high.y(),
                                    std::max(2, static_cast<int>(sheet.height() / 80.0)));
  for (const double value : ys.values) {
    const double y = sheet.y(value);
    svg += format_svg_line(kMapLeft, y, right, y, "stroke=\"#fff\" stroke-opacity=\".45\"");
    svg += format_svg_line(kMapLeft - 5, y, kMapLeft, y, "stroke=\"#33404d\"");
    svg += svg_text(kMapLeft - 8, y + 4, format_fixed(value, ys.decimals),
                    std::string(kMapTextStyle) + " text-anchor=\"end\"");
  }
  svg += "<rect x=\"" + format_fixed(kMapLeft, 1) + "\" y=\"" + format_fixed(kMapTop, 1) +
         "\" width=\"" + format_fixed(sheet.width(), 1) + "\" height=\"" +
         format_fixed(sheet.height(), 1) + "\" fill=\"none\" stroke=\"#33404d\"/>";
  svg += svg_text(kMapLeft + sheet.width() / 2, bottom + 37, "x (m)",
                  std::string(kMapTextStyle) + " text-anchor=\"middle\"");
  const double middle = kMapTop + sheet.height() / 2;
  return svg + svg_text(14, middle, "y (m)",
                        std::string(kMapTextStyle) +
                            " text-anchor=\"middle\" transform=\"rotate(-90 14 " +
                            format_fixed(middle, 1) + ")\"");
}

std::string barriers(const SiteMap& site, const MapToPixels& sheet) {
  std::string svg;
  for (const BarrierLine& line : site.barriers) {
    std::string path;
    const bool exits = line.counts == BarrierLine::Counts::kExits;
    Vec2 end(0.0, exits ? -INFINITY : INFINITY);  // its upper end; of exits the lower one
    for (const Vec2& point : line.vertices) {
      const Vec2 at(sheet.x(point.x()), sheet.y(point.y()));
      path += (path.empty() ? "M" : "L") + format_fixed(at.x(), 1) + " " + format_fixed(at.y(), 1);
      if (exits ? at.y() > end.y() : at.y() < end.y()) end = at;
    }
    for (const char* style :
         {"stroke=\"#fff\" stroke-width=\"5\"", "stroke=\"#111\" stroke-width=\"2.2\""}) {
      svg += "<path fill=\"none\" stroke-linecap=\"round\" " + std::string(style) + " d=\"" + path +
             "\"/>";
    }
    if (!site.counts_crossings) continue;
    const CountedDirectionArrow arrow = make_counted_direction_arrow(line);
    const Vec2 root(sheet.x(arrow.root.x()), sheet.y(arrow.root.y()));
    for (const double sign : {1.0, -1.0}) {
      if (sign < 0.0 && !arrow.both_directions) break;
      const Vec2 way(sign * arrow.way.x(), -sign * arrow.way.y());  // on the picture y points down
      const Vec2 across(-way.y(), way.x());
      const Vec2 tip = root + 11.0 * way, a = root + 5.0 * across, b = root - 5.0 * across;
      svg += "<path fill=\"#111\" stroke=\"#fff\" d=\"M" + format_fixed(a.x(), 1) + " " +
             format_fixed(a.y(), 1) + "L" + format_fixed(tip.x(), 1) + " " +
             format_fixed(tip.y(), 1) + "L" + format_fixed(b.x(), 1) + " " +
             format_fixed(b.y(), 1) + "Z\"><title>counted through " + escape_html(line.name) +
             "</title></path>";
    }
    // Named at that end, inside the frame.
    svg += svg_text(end.x(), exits ? end.y() + 17.0 : std::max(end.y() - 7.0, kMapTop + 13.0),
                    line.name, std::string(kMapHalo) + " text-anchor=\"middle\"");
  }
  return svg;
}

std::string releases(const SiteMap& site, const MapToPixels& sheet) {
  std::string svg;
  for (const ReleaseOutline& outline : site.release_outlines) {
    std::string path;
    for (const Vec2& corner : outline.corners) {
      path += (path.empty() ? "M" : "L") + format_fixed(sheet.x(corner.x()), 1) + " " +
              format_fixed(sheet.y(corner.y()), 1);
    }
    svg += draw_release_outline(path + "Z", outline.name);
  }
  for (const ReleasePosition& release : site.release_positions) {
    svg += draw_release_mark(sheet.x(release.position.x()), sheet.y(release.position.y()),
                             "release point " + std::to_string(release.point));
  }
  return svg;
}

std::string scale_bar(const MapToPixels& sheet) {
  const double rough = 110.0 / sheet.scale;
  double metres = round_up_to_nice_number(rough);
  if (metres * sheet.scale > 0.4 * sheet.width()) metres /= 2.0;
  const double length = metres * sheet.scale, x = kMapLeft + 14.0;
  const double y = kMapTop + sheet.height() - 18.0;
  const auto rect = [](double left, double top, double width, double height, const char* style) {
    return "<rect x=\"" + format_fixed(left, 1) + "\" y=\"" + format_fixed(top, 1) + "\" width=\"" +
           format_fixed(width, 1) + "\" height=\"" + format_fixed(height, 1) + "\" " + style + "/>";
  };
  return rect(x - 7, y - 20, length + 14, 32, "fill=\"#fff\" fill-opacity=\".8\"") +
         rect(x, y, length / 2, 5, "fill=\"#111\" stroke=\"#111\"") +
         rect(x + length / 2, y, length / 2, 5, "fill=\"#fff\" stroke=\"#111\"") +
         svg_text(x + length / 2, y - 6, format_significant_digits(metres, 2) + " m",
                  std::string(kMapTextStyle) + " text-anchor=\"middle\"");
}

std::string north_arrow(const MapToPixels& sheet) {
  const double x = kMapLeft + sheet.width() - 24.0, y = kMapTop + 16.0;
  return "<g><title>grid north: +y of the map</title><circle cx=\"" + format_fixed(x, 1) +
         "\" cy=\"" + format_fixed(y + 15, 1) +
         "\" r=\"21\" fill=\"#fff\" fill-opacity=\".8\"/><path fill=\"#111\" d=\"M" +
         format_fixed(x, 1) + " " + format_fixed(y - 2, 1) + "l7 19-7-5-7 5z\"/>" +
         svg_text(x, y + 31, "N",
                  "font-size=\"13\" font-weight=\"700\" text-anchor=\"middle\" fill=\"#111\"") +
         "</g>";
}

}  // namespace

std::string draw_svg_map(const SiteMap& site) {
  MapToPixels sheet;
  sheet.window = site.window;
  const Vec2 size = sheet.window.size();
  sheet.scale = std::min(kLongest / size.x(), kTallest / size.y());
  const MapLegend keys = draw_map_legend(site, sheet);

  const double width = kMapLeft + sheet.width() + kLegendWidth;
  const double height = std::max(kMapTop + sheet.height() + kBelow, keys.bottom);
  return make_svg_file(
      open_svg(width, height, "map of release points and barriers") + "<image x=\"" +
      format_fixed(kMapLeft, 1) + "\" y=\"" + format_fixed(kMapTop, 1) + "\" width=\"" +
      format_fixed(sheet.width(), 1) + "\" height=\"" + format_fixed(sheet.height(), 1) +
      "\" preserveAspectRatio=\"none\" href=\"" +
      draw_relief_image(site, static_cast<std::uint32_t>(std::lround(sheet.width()))) + "\"/>" +
      axes(sheet) + barriers(site, sheet) + releases(site, sheet) + scale_bar(sheet) +
      north_arrow(sheet) + keys.svg + "</svg>\n");
}

}  // namespace clast
