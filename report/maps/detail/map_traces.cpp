#include "report/maps/detail/map_traces.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/angle.hpp"
#include "report/charts/marks.hpp"
#include "report/charts/palette.hpp"
#include "report/html/html_page.hpp"
#include "report/maps/map_marks.hpp"
#include "report/maps/map_style.hpp"

namespace clast::report_detail {
namespace {

using Json = nlohmann::ordered_json;

/// Centimetres are enough on a map.
double on_map(double value) { return std::round(100.0 * value) / 100.0; }

std::string stop_note(const Comparison& comparison, const RunRow& row) {
  const ReleaseResult& result = row.record->result;
  const std::string file =
      comparison.results.size() > 1 ? "file " + std::to_string(row.file + 1) + ", " : std::string();
  return escape_html(file + "run " + std::to_string(row.record->run) + ", block " + row.block->id +
                     ", point " + std::to_string(row.record->point) + ", orientation " +
                     std::to_string(row.record->orientation)) +
         "<br>" + name_of(result.stop_reason) + " after " + format_fixed(result.duration, 1) +
         " s, runout " + format_fixed(row.runout, 1) + " m, lateral " +
         format_fixed(row.lateral * kDegreesPerRadian, 1) + " deg<br>z " +
         format_fixed(row.stop.z(), 2) + " m";
}

Json points_trace(const std::string& name) {
  return {{"type", "scatter"},
          {"mode", "markers"},
          {"name", escape_html(shorten_text(name, 40))},
          {"x", Json::array()},
          {"y", Json::array()},
          {"text", Json::array()},
          {"hovertemplate", "%{text}<br>x %{x:.2f}, y %{y:.2f} m<extra></extra>"}};
}

void add_point(Json& trace, const Vec2& place, const std::string& note) {
  trace["x"].push_back(on_map(place.x()));
  trace["y"].push_back(on_map(place.y()));
  trace["text"].push_back(note);
}

/// One entry of the legend for every block, or for every class where blocks are many.
void add_single_stops(const Comparison& comparison, Json& data) {
  const StopMarks stops = choose_stop_marks(comparison);
  for (const StopMark& mark : stops.marks) {
    Json trace = points_trace(stops.by_block ? mark.key + " (" + mark.garcia + ")" : mark.garcia);
    Json symbols = Json::array();
    for (const std::size_t index : comparison.groups[mark.group].rows) {
      const RunRow& row = comparison.rows[index];
      if (row.record->result.stop_reason == StopReason::kError) continue;
      add_point(trace, row.stop.head<2>(), stop_note(comparison, row));
      const bool rest = row.record->result.stop_reason == StopReason::kRest;
      symbols.push_back(std::string(mark.shape.plotly) + (rest ? "" : "-open"));
    }
    trace["meta"] = kStopsTraceName;
    trace["marker"] = {{"color", mark.colour},
                       {"symbol", symbols},
                       {"size", 8},
                       {"opacity", 0.8},
                       {"line", {{"width", 0.6}, {"color", "#fff"}}}};
    data.push_back(std::move(trace));
  }
}

/// Stops per square, coloured by factors, since densities span decades.
void add_stop_density(const Comparison& comparison, const PlanWindow& window, Json& data) {
  constexpr double kSquares = 130.0;  // along the longer side
  const double cell = window.size().maxCoeff() / kSquares;
  std::map<std::pair<int, int>, std::size_t> counts;
  std::size_t maximum = 1;
  for (const RunRow& row : comparison.rows) {
    if (row.record->result.stop_reason == StopReason::kError) continue;
    const Vec2 place = (row.stop.head<2>() - window.low) / cell;
    const std::pair square(static_cast<int>(std::floor(place.y())),
                           static_cast<int>(std::floor(place.x())));
    maximum = std::max(maximum, ++counts[square]);
  }
  const int columns = static_cast<int>(std::ceil(window.size().x() / cell));
  const int rows = static_cast<int>(std::ceil(window.size().y() / cell));
  Json level = Json::array(), number = Json::array();
  for (int row = 0; row < rows; ++row) {
    Json levels = Json::array(), numbers = Json::array();
    for (int column = 0; column < columns; ++column) {
      const auto found = counts.find({row, column});
      const bool none = found == counts.end();
      const double shown = none ? 0.0 : std::log10(static_cast<double>(found->second));
      levels.push_back(none ? Json() : Json(on_map(shown)));
      numbers.push_back(none ? Json() : Json(found->second));
    }
    level.push_back(std::move(levels));
    number.push_back(std::move(numbers));
  }
  Json scale = Json::array(), ticks = Json::array(), labels = Json::array();
  for (std::size_t i = 0; i < kDensityColours.size(); ++i) {
    scale.push_back({static_cast<double>(i) / (kDensityColours.size() - 1), kDensityColours[i]});
  }
  for (std::size_t decade = 1, k = 0; decade <= maximum; decade *= 10, ++k) {
    ticks.push_back(k);
    labels.push_back(std::to_string(decade));
  }
  data.push_back({{"type", "heatmap"},
                  {"name", "stops"},
                  {"meta", kStopsTraceName},
                  {"x0", window.low.x() + 0.5 * cell},
                  {"dx", cell},
                  {"y0", window.low.y() + 0.5 * cell},
                  {"dy", cell},
                  {"z", level},
                  {"customdata", number},
                  {"colorscale", scale},
                  {"opacity", kLayerOpacity},
                  {"hovertemplate", "%{customdata} stops<extra></extra>"},
                  {"colorbar",
                   {{"title", {{"text", "stops<br>per square"}}},
                    {"tickvals", ticks},
                    {"ticktext", labels},
                    {"len", 0.5},
                    {"thickness", 14}}}});
}

void add_measured(const Comparison& comparison, Json& data) {
  if (!comparison.measured) return;
  Json trace = points_trace("measured stop");
  for (const MeasuredStop& stop : comparison.measured->stops) {
    add_point(trace, stop.position,
              "measured stop" + (stop.block.empty() ? "" : ", block " + escape_html(stop.block)) +
                  "<br>runout " + format_fixed(stop.runout, 1) + " m");
  }
  trace["marker"] = {{"color", kMeasuredStopColour},
                     {"symbol", kMeasuredStopShape.plotly},
                     {"size", 10},
                     {"line", {{"width", 2}}}};
  data.push_back(std::move(trace));
}

}  // namespace

void add_stop_traces(const Comparison& comparison, const PlanWindow& window, Json& data) {
  if (comparison.rows.size() > kMaxSingleStops) {
    add_stop_density(comparison, window, data);
  } else {
    add_single_stops(comparison, data);
  }
  add_measured(comparison, data);
}

void add_release_traces(const SiteMap& site, Json& data) {
  for (const ReleaseOutline& outline : site.release_outlines) {
    Json trace = points_trace(outline.name);
    trace["mode"] = "lines";
    for (const Vec2& corner : outline.corners) add_point(trace, corner, escape_html(outline.name));
    add_point(trace, outline.corners.front(), escape_html(outline.name));
    trace["line"] = {{"color", "#111"}, {"width", 2}, {"dash", "dash"}};
    data.push_back(std::move(trace));
  }
  if (site.release_positions.empty()) return;
  Json trace = points_trace("release point");
  for (const ReleasePosition& release : site.release_positions) {
    add_point(trace, release.position, "release point " + std::to_string(release.point));
  }
  trace["marker"] = {
      {"color", "#111"}, {"symbol", "x-thin-open"}, {"size", 10}, {"line", {{"width", 2.4}}}};
  data.push_back(std::move(trace));
}

void add_barrier_traces(const SiteMap& site, Json& data, Json& notes) {
  for (const BarrierLine& line : site.barriers) {
    Json trace = points_trace(line.name);
    trace["mode"] = "lines";
    for (const Vec2& point : line.vertices) add_point(trace, point, escape_html(line.name));
    trace["line"] = {{"color", kBarrierColour}, {"width", 3}};
    trace["showlegend"] = false;
    data.push_back(std::move(trace));
    const CountedDirectionArrow arrow = make_counted_direction_arrow(line);
    constexpr double kArrow = 26.0;  // px
    notes.push_back({{"x", on_map(arrow.root.x())},
                     {"y", on_map(arrow.root.y())},
                     {"ax", -kArrow * arrow.way.x()},
                     {"ay", kArrow * arrow.way.y()},
                     {"showarrow", true},
                     {"arrowhead", 2},
                     {"arrowside", arrow.both_directions ? "end+start" : "end"},
                     {"startarrowhead", 2},
                     {"arrowwidth", 2},
                     {"arrowcolor", kBarrierColour},
                     {"text", "<b>" + escape_html(line.name) + "</b>"},
                     {"bgcolor", "rgba(255,255,255,.7)"}});
  }
}

void add_zone_traces(const SiteMap& site, Json& data) {
  const std::vector<std::string>& zones = site.terrain->zone_names;
  for (std::size_t zone = 0; zone < zones.size(); ++zone) {
    Json trace = points_trace("ground: " + zones[zone]);
    trace["x"].push_back(Json());
    trace["y"].push_back(Json());
    trace["marker"] = {{"symbol", "square"},
                       {"size", 12},
                       {"color", format_colour(zone_colour(zones[zone], zone))}};
    data.push_back(std::move(trace));
  }
}

}  // namespace clast::report_detail
