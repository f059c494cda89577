#include "study/report/svg_map.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

#include "core/html_page.hpp"
#include "study/report/map_legend.hpp"
#include "study/report/map_marks.hpp"
#include "study/report/ticks.hpp"
#include "terrain/relief.hpp"

namespace clast {
namespace {

constexpr double kBelow = 44.0;
constexpr double kLongest = 790.0, kTallest = 640.0;  // of the map itself, px
constexpr double kLegendWidth = 196.0;
constexpr double kNarrowest = 0.45;  // height over width of the window, and the other way round
constexpr const char* kHalo =
    "font-size=\"12.5\" font-weight=\"600\" fill=\"#111\" stroke=\"#fff\" stroke-width=\"3\" "
    "paint-order=\"stroke\"";

void include(Window& window, const Vec2& point) {
  if (!point.allFinite()) return;
  window.low = window.low.cwiseMin(point);
  window.high = window.high.cwiseMax(point);
}

/// Releases, stops and barriers with a margin, neither too long nor too thin.
Sheet sheet_of(const Comparison& comparison) {
  Window window{Vec2::Constant(INFINITY), Vec2::Constant(-INFINITY)};
  for (const RunRow& row : comparison.rows) {
    include(window, row.start.head<2>());
    if (row.record->result.stop_reason != StopReason::kError) include(window, row.stop.head<2>());
  }
  for (const BarrierLine& line : comparison.lines) {
    include(window, line.from);
    include(window, line.to);
  }
  if (comparison.measured) {
    for (const MeasuredStop& stop : comparison.measured->stops) include(window, stop.place);
  }
  if (comparison.groups.empty()) {  // a plan: where blocks may go is not known
    const CampaignResults& first = comparison.results.front();
    for (const Vec3& vertex : first.terrain.surface.vertices) {
      include(window, first.frame.map(vertex).head<2>());
    }
  }
  const double longer = std::max(window.size().maxCoeff(), 4.0);
  const Vec2 middle = 0.5 * (window.low + window.high);
  Vec2 size = window.size() + Vec2::Constant(0.14 * longer);
  size = size.cwiseMax(kNarrowest * size.maxCoeff());
  Sheet sheet;
  sheet.window = {middle - 0.5 * size, middle + 0.5 * size};
  sheet.scale = std::min(kLongest / size.x(), kTallest / size.y());
  return sheet;
}

std::string relief_image(const Comparison& comparison, const Sheet& sheet, double interval) {
  const CampaignResults& first = comparison.results.front();
  const Vec2 origin = first.frame.origin.head<2>();
  const Relief relief =
      sampled(first.terrain, {sheet.window.low - origin, sheet.window.high - origin},
              static_cast<std::uint32_t>(std::lround(sheet.width())));
  const std::string png =
      relief_png(relief, first.terrain.zone_names, first.frame.origin.z(), interval);
  return "<image x=\"" + fixed(kMapLeft, 1) + "\" y=\"" + fixed(kMapTop, 1) + "\" width=\"" +
         fixed(sheet.width(), 1) + "\" height=\"" + fixed(sheet.height(), 1) +
         "\" preserveAspectRatio=\"none\" href=\"" + png_link(png) + "\"/>";
}

std::string axes(const Sheet& sheet) {
  const double right = kMapLeft + sheet.width(), bottom = kMapTop + sheet.height();
  std::string svg;
  const Ticks xs = ticks(sheet.window.low.x(), sheet.window.high.x(),
                         std::max(2, static_cast<int>(sheet.width() / 95.0)));
  for (const double value : xs.values) {
    const double x = sheet.x(value);
    svg += svg_line(x, kMapTop, x, bottom, "stroke=\"#fff\" stroke-opacity=\".45\"");
    svg += svg_line(x, bottom, x, bottom + 5, "stroke=\"#33404d\"");
    svg += svg_text(x, bottom + 18, fixed(value, xs.decimals),
                    std::string(kMapText) + " text-anchor=\"middle\"");
  }
  const Ticks ys = ticks(sheet.window.low.y(), sheet.window.high.y(),
                         std::max(2, static_cast<int>(sheet.height() / 80.0)));
  for (const double value : ys.values) {
    const double y = sheet.y(value);
    svg += svg_line(kMapLeft, y, right, y, "stroke=\"#fff\" stroke-opacity=\".45\"");
    svg += svg_line(kMapLeft - 5, y, kMapLeft, y, "stroke=\"#33404d\"");
    svg += svg_text(kMapLeft - 8, y + 4, fixed(value, ys.decimals),
                    std::string(kMapText) + " text-anchor=\"end\"");
  }
  svg += "<rect x=\"" + fixed(kMapLeft, 1) + "\" y=\"" + fixed(kMapTop, 1) + "\" width=\"" +
         fixed(sheet.width(), 1) + "\" height=\"" + fixed(sheet.height(), 1) +
         "\" fill=\"none\" stroke=\"#33404d\"/>";
  svg += svg_text(kMapLeft + sheet.width() / 2, bottom + 37, "x (m)",
                  std::string(kMapText) + " text-anchor=\"middle\"");
  const double middle = kMapTop + sheet.height() / 2;
  return svg +
         svg_text(14, middle, "y (m)",
                  std::string(kMapText) + " text-anchor=\"middle\" transform=\"rotate(-90 14 " +
                      fixed(middle, 1) + ")\"");
}

std::string barriers(const Comparison& comparison, const Sheet& sheet) {
  std::string svg;
  for (const BarrierLine& line : comparison.lines) {
    const Vec2 from(sheet.x(line.from.x()), sheet.y(line.from.y()));
    const Vec2 to(sheet.x(line.to.x()), sheet.y(line.to.y()));
    const auto stroke = [&](const char* style) {
      return svg_line(from.x(), from.y(), to.x(), to.y(), style);
    };
    svg += stroke("stroke=\"#fff\" stroke-width=\"5\" stroke-linecap=\"round\"");
    svg += stroke("stroke=\"#111\" stroke-width=\"2.2\" stroke-linecap=\"round\"");
    const Vec2 run = to - from;
    if (run.norm() > 1.0) {
      // Forward is to the right of from -> to; on the picture y points down.
      const Vec2 along = run.normalized(), forward(-along.y(), along.x());
      const Vec2 root = 0.5 * (from + to), tip = root + 11.0 * forward;
      const Vec2 a = root + 5.0 * along, b = root - 5.0 * along;
      svg += "<path fill=\"#111\" stroke=\"#fff\" d=\"M" + fixed(a.x(), 1) + " " + fixed(a.y(), 1) +
             "L" + fixed(tip.x(), 1) + " " + fixed(tip.y(), 1) + "L" + fixed(b.x(), 1) + " " +
             fixed(b.y(), 1) + "Z\"><title>forward through " + escaped(line.name) +
             "</title></path>";
    }
    // Named at its upper end, inside the frame.
    const Vec2 end = from.y() < to.y() ? from : to;
    svg += svg_text(end.x(), std::max(end.y() - 7.0, kMapTop + 13.0), line.name,
                    std::string(kHalo) + " text-anchor=\"middle\"");
  }
  return svg;
}

std::string releases(const Comparison& comparison, const Sheet& sheet) {
  std::string svg;
  std::set<std::pair<double, double>> drawn;
  for (const RunRow& row : comparison.rows) {
    if (!drawn.emplace(row.start.x(), row.start.y()).second) continue;
    svg += release_mark(sheet.x(row.start.x()), sheet.y(row.start.y()),
                        "release point " + std::to_string(row.record->point));
  }
  return svg;
}

std::string stop_title(const Comparison& comparison, const RunRow& row) {
  const ReleaseResult& result = row.record->result;
  std::string title =
      comparison.results.size() > 1 ? "file " + std::to_string(row.file + 1) + ", " : std::string();
  title += "run " + std::to_string(row.record->run) + ", block " + row.block->id + ", point " +
           std::to_string(row.record->point) + ", orientation " +
           std::to_string(row.record->orientation) + "\n" + name_of(result.stop_reason) +
           " after " + fixed(result.duration, 1) + " s, runout " + fixed(row.runout, 1) +
           " m, lateral " + fixed(row.lateral * 180.0 / kPi, 1) + " deg\nx " +
           fixed(row.stop.x(), 2) + ", y " + fixed(row.stop.y(), 2) + ", z " +
           fixed(row.stop.z(), 2) + " m";
  return title;
}

/// One group of marks per block, so that a key can hide it.
std::string single_stops(const Comparison& comparison, const Sheet& sheet) {
  std::string svg;
  for (std::size_t g = 0; g < comparison.groups.size(); ++g) {
    const Group& group = comparison.groups[g];
    if (group.kind != GroupKind::kBlock || group.file) continue;
    svg += "<g class=\"" + block_class(g) + "\">";
    for (const std::size_t index : group.rows) {
      const RunRow& row = comparison.rows[index];
      if (row.record->result.stop_reason == StopReason::kError) continue;
      svg += stop_mark(sheet.x(row.stop.x()), sheet.y(row.stop.y()), row.block->garcia,
                       row.record->result.stop_reason == StopReason::kRest,
                       stop_title(comparison, row)) +
             "\n";
    }
    svg += "</g>";
  }
  return svg;
}

/// Stops seen in the field: upright crosses.
std::string measured_stops(const Comparison& comparison, const Sheet& sheet) {
  std::string svg;
  if (!comparison.measured) return svg;
  for (const MeasuredStop& stop : comparison.measured->stops) {
    const double x = sheet.x(stop.place.x()), y = sheet.y(stop.place.y());
    svg += "<g><title>measured stop" +
           (stop.block.empty() ? "" : ", block " + escaped(stop.block)) + ", runout " +
           fixed(stop.runout, 1) + " m</title>" +
           svg_line(x - 5, y, x + 5, y, "stroke=\"#c0104a\" stroke-width=\"2\"") +
           svg_line(x, y - 5, x, y + 5, "stroke=\"#c0104a\" stroke-width=\"2\"") + "</g>\n";
  }
  return svg;
}

std::string stop_density(const Comparison& comparison, const Sheet& sheet) {
  std::vector<Vec2> places;
  for (const RunRow& row : comparison.rows) {
    if (row.record->result.stop_reason == StopReason::kError) continue;
    places.emplace_back(sheet.x(row.stop.x()), sheet.y(row.stop.y()));
  }
  return density_squares(places, {kMapLeft, kMapTop}, "stops");
}

std::string scale_bar(const Sheet& sheet) {
  const double rough = 110.0 / sheet.scale;
  double metres = round_up_to_nice(rough);
  if (metres * sheet.scale > 0.4 * sheet.width()) metres /= 2.0;
  const double length = metres * sheet.scale, x = kMapLeft + 14.0;
  const double y = kMapTop + sheet.height() - 18.0;
  const auto rect = [](double left, double top, double width, double height, const char* style) {
    return "<rect x=\"" + fixed(left, 1) + "\" y=\"" + fixed(top, 1) + "\" width=\"" +
           fixed(width, 1) + "\" height=\"" + fixed(height, 1) + "\" " + style + "/>";
  };
  return rect(x - 7, y - 20, length + 14, 32, "fill=\"#fff\" fill-opacity=\".8\"") +
         rect(x, y, length / 2, 5, "fill=\"#111\" stroke=\"#111\"") +
         rect(x + length / 2, y, length / 2, 5, "fill=\"#fff\" stroke=\"#111\"") +
         svg_text(x + length / 2, y - 6, significant(metres, 2) + " m",
                  std::string(kMapText) + " text-anchor=\"middle\"");
}

std::string north_arrow(const Sheet& sheet) {
  const double x = kMapLeft + sheet.width() - 24.0, y = kMapTop + 16.0;
  return "<g><title>grid north: +y of the map</title><circle cx=\"" + fixed(x, 1) + "\" cy=\"" +
         fixed(y + 15, 1) +
         "\" r=\"21\" fill=\"#fff\" fill-opacity=\".8\"/><path fill=\"#111\" d=\"M" + fixed(x, 1) +
         " " + fixed(y - 2, 1) + "l7 19-7-5-7 5z\"/>" +
         svg_text(x, y + 31, "N",
                  "font-size=\"13\" font-weight=\"700\" text-anchor=\"middle\" fill=\"#111\"") +
         "</g>";
}

/// About a dozen contours over the heights the runs pass.
double contour_interval(const Comparison& comparison) {
  double low = INFINITY, high = -INFINITY;
  if (comparison.groups.empty()) {
    const CampaignResults& first = comparison.results.front();
    for (const Vec3& vertex : first.terrain.surface.vertices) {
      low = std::min(low, vertex.z());
      high = std::max(high, vertex.z());
    }
  }
  for (const RunRow& row : comparison.rows) {
    if (row.record->result.stop_reason == StopReason::kError) continue;
    low = std::min({low, row.start.z(), row.stop.z()});
    high = std::max({high, row.start.z(), row.stop.z()});
  }
  return std::max(0.1, round_up_to_nice((high - low) / 12.0));
}

}  // namespace

std::string svg_map(const Comparison& comparison) {
  const Sheet sheet = sheet_of(comparison);
  const double interval = contour_interval(comparison);
  const bool density = comparison.rows.size() > kMostSingleStops;
  const MapLegend keys = map_legend(comparison, sheet, interval, density);

  const double width = kMapLeft + sheet.width() + kLegendWidth;
  const double height = std::max(kMapTop + sheet.height() + kBelow, keys.bottom);
  return svg_open(width, height, "map of stops, release points and barriers") +
         relief_image(comparison, sheet, interval) + axes(sheet) +
         (density ? stop_density(comparison, sheet) : single_stops(comparison, sheet)) +
         measured_stops(comparison, sheet) + barriers(comparison, sheet) +
         releases(comparison, sheet) + scale_bar(sheet) + north_arrow(sheet) + keys.svg +
         "</svg>\n";
}

}  // namespace clast
