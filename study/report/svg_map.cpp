#include "study/report/svg_map.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

#include "study/report/html_page.hpp"
#include "study/report/palette.hpp"
#include "study/report/relief.hpp"
#include "study/report/ticks.hpp"

namespace clast {
namespace {

constexpr double kLeft = 88.0, kTop = 12.0, kBelow = 44.0;
constexpr double kLongest = 790.0, kTallest = 640.0;  // of the map itself, px
constexpr double kLegendWidth = 196.0;
constexpr double kNarrowest = 0.45;  // height over width of the window, and the other way round
constexpr const char* kSmall = "font-size=\"12\" fill=\"#33404d\"";
constexpr const char* kHalo =
    "font-size=\"12.5\" font-weight=\"600\" fill=\"#111\" stroke=\"#fff\" stroke-width=\"3\" "
    "paint-order=\"stroke\"";

/// The part of the plan that is drawn (map coordinates) and where it lies on the picture.
struct Sheet {
  Window window;
  double scale = 1.0;  ///< px/m

  double width() const { return window.size().x() * scale; }
  double height() const { return window.size().y() * scale; }
  double x(double map_x) const { return kLeft + (map_x - window.low.x()) * scale; }
  double y(double map_y) const { return kTop + (window.high.y() - map_y) * scale; }
};

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
  return "<image x=\"" + fixed(kLeft, 1) + "\" y=\"" + fixed(kTop, 1) + "\" width=\"" +
         fixed(sheet.width(), 1) + "\" height=\"" + fixed(sheet.height(), 1) +
         "\" preserveAspectRatio=\"none\" href=\"data:image/png;base64," + base64(png) + "\"/>";
}

std::string axes(const Sheet& sheet) {
  const double right = kLeft + sheet.width(), bottom = kTop + sheet.height();
  std::string svg;
  const Ticks xs = ticks(sheet.window.low.x(), sheet.window.high.x(),
                         std::max(2, static_cast<int>(sheet.width() / 95.0)));
  for (const double value : xs.values) {
    const double x = sheet.x(value);
    svg += svg_line(x, kTop, x, bottom, "stroke=\"#fff\" stroke-opacity=\".45\"");
    svg += svg_line(x, bottom, x, bottom + 5, "stroke=\"#33404d\"");
    svg += svg_text(x, bottom + 18, fixed(value, xs.decimals),
                    std::string(kSmall) + " text-anchor=\"middle\"");
  }
  const Ticks ys = ticks(sheet.window.low.y(), sheet.window.high.y(),
                         std::max(2, static_cast<int>(sheet.height() / 80.0)));
  for (const double value : ys.values) {
    const double y = sheet.y(value);
    svg += svg_line(kLeft, y, right, y, "stroke=\"#fff\" stroke-opacity=\".45\"");
    svg += svg_line(kLeft - 5, y, kLeft, y, "stroke=\"#33404d\"");
    svg += svg_text(kLeft - 8, y + 4, fixed(value, ys.decimals),
                    std::string(kSmall) + " text-anchor=\"end\"");
  }
  svg += "<rect x=\"" + fixed(kLeft, 1) + "\" y=\"" + fixed(kTop, 1) + "\" width=\"" +
         fixed(sheet.width(), 1) + "\" height=\"" + fixed(sheet.height(), 1) +
         "\" fill=\"none\" stroke=\"#33404d\"/>";
  svg += svg_text(kLeft + sheet.width() / 2, bottom + 37, "x (m)",
                  std::string(kSmall) + " text-anchor=\"middle\"");
  const double middle = kTop + sheet.height() / 2;
  return svg + svg_text(14, middle, "y (m)",
                        std::string(kSmall) + " text-anchor=\"middle\" transform=\"rotate(-90 14 " +
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
    svg += svg_text(end.x(), std::max(end.y() - 7.0, kTop + 13.0), line.name,
                    std::string(kHalo) + " text-anchor=\"middle\"");
  }
  return svg;
}

std::string release_mark(double x, double y, const std::string& title) {
  const std::string at = fixed(x, 1) + " " + fixed(y, 1);
  return "<path fill=\"none\" stroke=\"#fff\" stroke-width=\"5\" d=\"M" + at +
         "m-6-6l12 12m0-12l-12 12\"/><path fill=\"none\" stroke=\"#111\" stroke-width=\"2.4\" "
         "d=\"M" +
         at + "m-5-5l10 10m0-10l-10 10\">" +
         (title.empty() ? "" : "<title>" + escaped(title) + "</title>") + "</path>";
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

/// Circle for compact, diamond for the rest; hollow when the run did not come to rest.
std::string stop_mark(double x, double y, const std::string& garcia, bool at_rest,
                      const std::string& title) {
  const std::string paint = at_rest
                                ? "fill=\"" + class_colour(garcia) +
                                      "\" fill-opacity=\".8\" stroke=\"#fff\" stroke-width=\".7\""
                                : "fill=\"#fff\" fill-opacity=\".6\" stroke-width=\"1.6\" "
                                  "stroke=\"" +
                                      class_colour(garcia) + "\"";
  const std::string tail = title.empty() ? "/>" : "><title>" + escaped(title) + "</title>";
  if (garcia == "compact") {
    return "<circle class=\"stop\" cx=\"" + fixed(x, 1) + "\" cy=\"" + fixed(y, 1) +
           "\" r=\"3.6\" " + paint + tail + (title.empty() ? "" : "</circle>");
  }
  return "<path class=\"stop\" d=\"M" + fixed(x, 1) + " " + fixed(y - 4.8, 1) +
         "l4.8 4.8-4.8 4.8-4.8-4.8z\" " + paint + tail + (title.empty() ? "" : "</path>");
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

std::string block_class(std::size_t group) { return "block-" + std::to_string(group); }

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

constexpr double kDensityCell = 7.0;  // px
constexpr std::array<const char*, 5> kDensityColours = {"#fcbba1", "#fb6a4a", "#de2d26", "#a50f15",
                                                        "#4a0008"};

/// Stops per square; colours step by factors, since densities span decades.
std::string stop_density(const Comparison& comparison, const Sheet& sheet) {
  std::map<std::pair<int, int>, std::size_t> counts;
  std::size_t most = 1;
  for (const RunRow& row : comparison.rows) {
    if (row.record->result.stop_reason == StopReason::kError) continue;
    const int i = static_cast<int>(std::floor((sheet.x(row.stop.x()) - kLeft) / kDensityCell));
    const int j = static_cast<int>(std::floor((sheet.y(row.stop.y()) - kTop) / kDensityCell));
    most = std::max(most, ++counts[{i, j}]);
  }
  std::string svg;
  for (const auto& [cell, count] : counts) {
    const double level = std::log(static_cast<double>(count)) /
                         std::log(static_cast<double>(most) + 1.0) *
                         static_cast<double>(kDensityColours.size());
    svg += "<rect x=\"" + fixed(kLeft + kDensityCell * cell.first, 1) + "\" y=\"" +
           fixed(kTop + kDensityCell * cell.second, 1) + "\" width=\"7\" height=\"7\" fill=\"" +
           kDensityColours[std::min(static_cast<std::size_t>(level), kDensityColours.size() - 1)] +
           "\" fill-opacity=\".85\"><title>" + std::to_string(count) + " stops</title></rect>";
  }
  return svg;
}

std::string scale_bar(const Sheet& sheet) {
  const double rough = 110.0 / sheet.scale;
  double metres = round_up_to_nice(rough);
  if (metres * sheet.scale > 0.4 * sheet.width()) metres /= 2.0;
  const double length = metres * sheet.scale, x = kLeft + 14.0;
  const double y = kTop + sheet.height() - 18.0;
  const auto rect = [](double left, double top, double width, double height, const char* style) {
    return "<rect x=\"" + fixed(left, 1) + "\" y=\"" + fixed(top, 1) + "\" width=\"" +
           fixed(width, 1) + "\" height=\"" + fixed(height, 1) + "\" " + style + "/>";
  };
  return rect(x - 7, y - 20, length + 14, 32, "fill=\"#fff\" fill-opacity=\".8\"") +
         rect(x, y, length / 2, 5, "fill=\"#111\" stroke=\"#111\"") +
         rect(x + length / 2, y, length / 2, 5, "fill=\"#fff\" stroke=\"#111\"") +
         svg_text(x + length / 2, y - 6, significant(metres, 2) + " m",
                  std::string(kSmall) + " text-anchor=\"middle\"");
}

std::string north_arrow(const Sheet& sheet) {
  const double x = kLeft + sheet.width() - 24.0, y = kTop + 16.0;
  return "<g><title>grid north: +y of the map</title><circle cx=\"" + fixed(x, 1) + "\" cy=\"" +
         fixed(y + 15, 1) +
         "\" r=\"21\" fill=\"#fff\" fill-opacity=\".8\"/><path fill=\"#111\" d=\"M" + fixed(x, 1) +
         " " + fixed(y - 2, 1) + "l7 19-7-5-7 5z\"/>" +
         svg_text(x, y + 31, "N",
                  "font-size=\"13\" font-weight=\"700\" text-anchor=\"middle\" fill=\"#111\"") +
         "</g>";
}

/// Rows of marks and words beside the map.
class Legend {
 public:
  explicit Legend(double x) : x_(x) {}

  void head(const std::string& text) {
    y_ += y_ > kTop + 14.0 ? 10.0 : 0.0;
    svg_ += svg_text(x_, y_, text, "font-size=\"12.5\" font-weight=\"600\" fill=\"#1d2733\"");
    y_ += 20.0;
  }
  void row(const std::string& mark, const std::string& text) {
    svg_ += mark + svg_text(x_ + 24, y_, text, kSmall);
    y_ += 19.0;
  }
  void swatch(const std::string& colour, const std::string& text) {
    row("<rect x=\"" + fixed(x_, 1) + "\" y=\"" + fixed(y_ - 10, 1) +
            "\" width=\"16\" height=\"12\" fill=\"" + colour + "\" stroke=\"#8a949e\"/>",
        text);
  }
  /// A row that hides and shows everything of class `shows`.
  void key(const std::string& mark, const std::string& text, const std::string& shows) {
    svg_ += "<g class=\"key\" data-shows=\"" + shows + "\"><title>click to hide or show</title>";
    row(mark, text);
    svg_ += "</g>";
  }
  double mark_x() const { return x_ + 8.0; }
  double mark_y() const { return y_ - 4.0; }
  double bottom() const { return y_; }
  const std::string& svg() const { return svg_; }

 private:
  double x_;
  double y_ = kTop + 12.0;
  std::string svg_;
};

std::string rgb_text(const Rgb& colour) {
  return "rgb(" + std::to_string(colour[0]) + "," + std::to_string(colour[1]) + "," +
         std::to_string(colour[2]) + ")";
}

std::string shortened(const std::string& text) {
  constexpr std::size_t kMost = 24;
  if (text.size() <= kMost) return text;
  std::size_t end = kMost - 1;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) --end;  // whole UTF-8
  return text.substr(0, end) + "\xE2\x80\xA6";
}

Legend legend(const Comparison& comparison, const Sheet& sheet, double interval, bool density) {
  constexpr std::size_t kMostBlocks = 18;  // more would outgrow the map
  Legend legend(kLeft + sheet.width() + 22.0);
  if (density) {
    legend.head("Stops per square");
    legend.swatch(kDensityColours.front(), "few");
    legend.swatch(kDensityColours.back(), "many");
  } else {
    legend.head("Stops by class");
    for (const Group& group : comparison.groups) {
      if (group.kind != GroupKind::kGarcia || group.file) continue;
      legend.row(stop_mark(legend.mark_x(), legend.mark_y(), group.key, true, ""),
                 shortened(group.key) + " (" + std::to_string(group.rows.size()) + ")");
    }
    legend.row(stop_mark(legend.mark_x(), legend.mark_y(), "compact", false, ""), "not at rest");
    legend.head("Blocks (click to hide)");
    std::size_t listed = 0;
    for (std::size_t g = 0; g < comparison.groups.size() && listed < kMostBlocks; ++g) {
      const Group& group = comparison.groups[g];
      if (group.kind != GroupKind::kBlock || group.file) continue;
      ++listed;
      legend.key(stop_mark(legend.mark_x(), legend.mark_y(),
                           comparison.rows[group.rows.front()].block->garcia, true, ""),
                 shortened(group.key), block_class(g));
    }
  }
  legend.head("Site");
  legend.row(release_mark(legend.mark_x(), legend.mark_y(), ""), "release point");
  if (!comparison.lines.empty()) {
    legend.row(svg_line(legend.mark_x() - 8, legend.mark_y(), legend.mark_x() + 8, legend.mark_y(),
                        "stroke=\"#111\" stroke-width=\"2.2\""),
               "barrier, arrow forward");
  }
  legend.row(svg_line(legend.mark_x() - 8, legend.mark_y(), legend.mark_x() + 8, legend.mark_y(),
                      "stroke=\"#7a6245\" stroke-width=\"1.2\""),
             "contours every " + significant(interval, 2) + " m");
  const std::vector<std::string>& zones = comparison.results.front().terrain.zone_names;
  if (!zones.empty()) legend.head("Ground zones");
  for (std::size_t zone = 0; zone < zones.size(); ++zone) {
    legend.swatch(rgb_text(zone_tint(zones[zone], zone)), shortened(zones[zone]));
  }
  return legend;
}

/// About a dozen contours over the heights the runs pass.
double contour_interval(const Comparison& comparison) {
  double low = INFINITY, high = -INFINITY;
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
  const Legend keys = legend(comparison, sheet, interval, density);

  const double width = kLeft + sheet.width() + kLegendWidth;
  const double height = std::max(kTop + sheet.height() + kBelow, keys.bottom());
  return svg_open(width, height, "map of stops, release points and barriers") +
         relief_image(comparison, sheet, interval) + axes(sheet) +
         (density ? stop_density(comparison, sheet) : single_stops(comparison, sheet)) +
         barriers(comparison, sheet) + releases(comparison, sheet) + scale_bar(sheet) +
         north_arrow(sheet) + keys.svg() + "</svg>\n";
}

}  // namespace clast
