#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "report/charts/marks.hpp"
#include "report/charts/plotly_chart.hpp"
#include "report/html/html_page.hpp"
#include "report/maps/map_window.hpp"
#include "report/pages/report_groups.hpp"
#include "report/pages/report_sections.hpp"

namespace clast::report_detail {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::uint32_t kReliefColumns = 1000;
constexpr std::size_t kMostBlocks = 24;  // with an entry each in the legend

/// Centimetres are enough on a map.
double on_map(double value) { return std::round(100.0 * value) / 100.0; }

std::string stop_note(const Comparison& comparison, const RunRow& row) {
  const ReleaseResult& result = row.record->result;
  const std::string file =
      several_files(comparison) ? "file " + std::to_string(row.file + 1) + ", " : std::string();
  return escaped(file + "run " + std::to_string(row.record->run) + ", block " + row.block->id +
                 ", point " + std::to_string(row.record->point) + ", orientation " +
                 std::to_string(row.record->orientation)) +
         "<br>" + name_of(result.stop_reason) + " after " + fixed(result.duration, 1) +
         " s, runout " + fixed(row.runout, 1) + " m, lateral " + fixed(row.lateral * kDegrees, 1) +
         " deg<br>z " + fixed(row.stop.z(), 2) + " m";
}

Json points_trace(const std::string& name) {
  return {{"type", "scatter"},
          {"mode", "markers"},
          {"name", escaped(shortened(name, 40))},
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
  const auto count = [&](GroupKind kind) {
    return std::count_if(comparison.groups.begin(), comparison.groups.end(),
                         [&](const Group& group) { return group.kind == kind && !group.file; });
  };
  const GroupKind kind = static_cast<std::size_t>(count(GroupKind::kBlock)) > kMostBlocks
                             ? GroupKind::kGarcia
                             : GroupKind::kBlock;
  for (const Group& group : comparison.groups) {
    if (group.kind != kind || group.file) continue;
    const std::string garcia = comparison.rows[group.rows.front()].block->garcia;
    Json trace = points_trace(kind == GroupKind::kBlock ? group.key + " (" + garcia + ")" : garcia);
    const std::string symbol = garcia == "compact" ? "circle" : "diamond";
    Json symbols = Json::array();
    for (const std::size_t index : group.rows) {
      const RunRow& row = comparison.rows[index];
      if (row.record->result.stop_reason == StopReason::kError) continue;
      add_point(trace, row.stop.head<2>(), stop_note(comparison, row));
      const bool rest = row.record->result.stop_reason == StopReason::kRest;
      symbols.push_back(rest ? symbol : symbol + "-open");
    }
    trace["marker"] = {{"color", class_colour(garcia)},
                       {"symbol", symbols},
                       {"size", 7},
                       {"opacity", 0.75},
                       {"line", {{"width", 0.6}, {"color", "#fff"}}}};
    data.push_back(std::move(trace));
  }
}

/// Stops per square, coloured by factors, since densities span decades.
void add_stop_density(const Comparison& comparison, const Window& window, Json& data) {
  constexpr double kSquares = 130.0;  // along the longer side
  const double cell = window.size().maxCoeff() / kSquares;
  std::map<std::pair<int, int>, std::size_t> counts;
  std::size_t most = 1;
  for (const RunRow& row : comparison.rows) {
    if (row.record->result.stop_reason == StopReason::kError) continue;
    const Vec2 place = (row.stop.head<2>() - window.low) / cell;
    const std::pair square(static_cast<int>(std::floor(place.y())),
                           static_cast<int>(std::floor(place.x())));
    most = std::max(most, ++counts[square]);
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
  for (std::size_t decade = 1, k = 0; decade <= most; decade *= 10, ++k) {
    ticks.push_back(k);
    labels.push_back(std::to_string(decade));
  }
  data.push_back({{"type", "heatmap"},
                  {"name", "stops"},
                  {"x0", window.low.x() + 0.5 * cell},
                  {"dx", cell},
                  {"y0", window.low.y() + 0.5 * cell},
                  {"dy", cell},
                  {"z", level},
                  {"customdata", number},
                  {"colorscale", scale},
                  {"opacity", 0.85},
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
    add_point(trace, stop.place,
              "measured stop" + (stop.block.empty() ? "" : ", block " + escaped(stop.block)) +
                  "<br>runout " + fixed(stop.runout, 1) + " m");
  }
  trace["marker"] = {
      {"color", "#c0104a"}, {"symbol", "cross-thin-open"}, {"size", 10}, {"line", {{"width", 2}}}};
  data.push_back(std::move(trace));
}

void add_releases(const Comparison& comparison, Json& data) {
  Json trace = points_trace("release point");
  std::set<std::pair<double, double>> drawn;
  for (const RunRow& row : comparison.rows) {
    if (!drawn.emplace(row.start.x(), row.start.y()).second) continue;
    add_point(trace, row.start.head<2>(), "release point " + std::to_string(row.record->point));
  }
  trace["marker"] = {
      {"color", "#111"}, {"symbol", "x-thin-open"}, {"size", 10}, {"line", {{"width", 2.4}}}};
  data.push_back(std::move(trace));
}

/// Lines with their names, and an arrow the way that counts from the middle of each.
void add_barriers(const Comparison& comparison, Json& data, Json& notes) {
  for (const BarrierLine& line : comparison.lines) {
    Json trace = points_trace(line.name);
    trace["mode"] = "lines";
    for (const Vec2& point : line.through) add_point(trace, point, escaped(line.name));
    trace["line"] = {{"color", "#111"}, {"width", 3}};
    trace["showlegend"] = false;
    data.push_back(std::move(trace));
    const CountArrow arrow = count_arrow(line);
    constexpr double kArrow = 26.0;  // px
    notes.push_back({{"x", on_map(arrow.root.x())},
                     {"y", on_map(arrow.root.y())},
                     {"ax", -kArrow * arrow.way.x()},
                     {"ay", kArrow * arrow.way.y()},
                     {"showarrow", true},
                     {"arrowhead", 2},
                     {"arrowside", arrow.both_ways ? "end+start" : "end"},
                     {"startarrowhead", 2},
                     {"arrowwidth", 2},
                     {"arrowcolor", "#111"},
                     {"text", "<b>" + escaped(line.name) + "</b>"},
                     {"bgcolor", "rgba(255,255,255,.7)"}});
  }
}

/// Zones as empty entries of the legend.
void add_zones(const Comparison& comparison, Json& data) {
  const std::vector<std::string>& zones = comparison.results.front().terrain.zone_names;
  for (std::size_t zone = 0; zone < zones.size(); ++zone) {
    const Rgb tint = zone_tint(zones[zone], zone);
    Json trace = points_trace("ground: " + zones[zone]);
    trace["x"].push_back(Json());
    trace["y"].push_back(Json());
    trace["marker"] = {{"symbol", "square"},
                       {"size", 12},
                       {"color", "rgb(" + std::to_string(tint[0]) + "," + std::to_string(tint[1]) +
                                     "," + std::to_string(tint[2]) + ")"}};
    data.push_back(std::move(trace));
  }
}

Json axis(const char* name, double low, double high) {
  return {{"title", {{"text", name}}},
          {"range", {on_map(low), on_map(high)}},
          {"exponentformat", "none"},
          {"tickformat", ".12~g"},
          {"gridcolor", "rgba(255,255,255,.45)"},
          {"zeroline", false}};
}

/// A map of a window over the relief of the ground.
std::string figure_over_relief(const Comparison& comparison, const Window& window,
                               const std::string& label, const Json& data, const Json& notes) {
  Json y = axis("y, m", window.low.y(), window.high.y());
  y["scaleanchor"] = "x";
  const Json layout = {
      // the buttons have the margin above to themselves, beside no name
      {"height", 640},
      {"margin", {{"l", 74}, {"r", 10}, {"t", 36}, {"b", 48}}},
      {"font",
       {{"family", "system-ui,Segoe UI,Roboto,Helvetica Neue,Arial,sans-serif"}, {"size", 12}}},
      {"xaxis", axis("x, m", window.low.x(), window.high.x())},
      {"yaxis", y},
      // Above the map are the buttons, beside it nothing, so that it is wide on a telephone too.
      {"legend", {{"orientation", "h"}, {"y", -0.15}, {"yanchor", "top"}}},
      {"dragmode", "pan"},
      {"hovermode", "closest"},
      {"annotations", notes},
      {"images",
       {{{"source", relief_image(comparison, window, kReliefColumns, contour_interval(comparison))},
         {"xref", "x"},
         {"yref", "y"},
         {"x", window.low.x()},
         {"y", window.high.y()},
         {"sizex", window.size().x()},
         {"sizey", window.size().y()},
         {"sizing", "stretch"},
         {"layer", "below"}}}}};
  const Json figure = {{"data", data}, {"layout", layout}, {"config", {{"scrollZoom", true}}}};
  return plotly_figure(label, "map", figure.dump(-1, ' ', false, Json::error_handler_t::replace));
}

std::string map_figure(const Comparison& comparison) {
  const Window window = map_window(comparison);
  Json data = Json::array(), notes = Json::array();
  if (comparison.rows.size() > kMostSingleStops) {
    add_stop_density(comparison, window, data);
  } else {
    add_single_stops(comparison, data);
  }
  add_measured(comparison, data);
  add_barriers(comparison, data, notes);
  add_releases(comparison, data);
  add_zones(comparison, data);
  return figure_over_relief(comparison, window, "map of stops, release points and barriers", data,
                            notes);
}

/// More cells than this are joined for the page, each with the largest value of those it joins.
constexpr double kMostMapCells = 1e5;

/// A layer of rasters as coloured cells.
Json coloured_cells(const MapRasters& rasters, const RasterLayer& layer, const std::string& unit) {
  const double cells = static_cast<double>(rasters.columns) * rasters.rows;
  const auto joined =
      static_cast<std::uint32_t>(std::ceil(std::sqrt(std::max(1.0, cells / kMostMapCells))));
  const std::uint32_t columns = (rasters.columns + joined - 1) / joined;
  const std::uint32_t rows = (rasters.rows + joined - 1) / joined;
  std::vector<float> largest(std::size_t{columns} * rows, NAN);
  for (std::uint32_t row = 0; row < rasters.rows; ++row) {
    for (std::uint32_t column = 0; column < rasters.columns; ++column) {
      const float value = layer.value[std::size_t{row} * rasters.columns + column];
      float& cell = largest[std::size_t{row / joined} * columns + column / joined];
      if (std::isfinite(value) && !(cell >= value)) cell = value;
    }
  }
  Json z = Json::array();
  for (std::uint32_t row = 0; row < rows; ++row) {
    Json values = Json::array();
    for (std::uint32_t column = 0; column < columns; ++column) {
      const float value = largest[std::size_t{row} * columns + column];
      values.push_back(std::isfinite(value) ? Json(on_map(value)) : Json());
    }
    z.push_back(std::move(values));
  }
  const double width = rasters.cell * joined;
  const double top = rasters.corner.y() + rasters.cell * rasters.rows;
  return {{"type", "heatmap"},
          {"name", layer.name},
          {"x0", rasters.corner.x() + 0.5 * width},
          {"dx", width},
          {"y0", top - 0.5 * width},
          {"dy", -width},
          {"z", z},
          {"colorscale", "YlOrRd"},
          {"reversescale", true},
          {"opacity", 0.85},
          {"hovertemplate", "%{z:.2f} " + unit + "<br>x %{x:.2f}, y %{y:.2f} m<extra></extra>"},
          {"colorbar", {{"title", {{"text", unit}}}, {"len", 0.5}, {"thickness", 14}}}};
}

}  // namespace

std::string deposit_map(const Comparison& comparison, const MapRasters& rasters) {
  if (rasters.layers.empty()) return "";
  const Window window = map_window(comparison);
  Json data = Json::array(), notes = Json::array();
  data.push_back(coloured_cells(rasters, rasters.layers.front(), "m"));
  add_barriers(comparison, data, notes);
  return figure_over_relief(comparison, window, "map of the thickness of the deposit", data, notes);
}

std::string map_section(const Comparison& comparison) {
  const bool density = comparison.rows.size() > kMostSingleStops;
  const std::string stops =
      density ? "The " + std::to_string(comparison.rows.size()) +
                    " stops are shown by their density; stops.gpkg has each of them. "
              : "A click on a name in the legend hides or shows its stops, a double click leaves "
                "it alone; open marks did not come to rest. ";
  return section(
      "Where the blocks stop",
      paragraph("Centres of mass at the end of each run, in map coordinates. The wheel zooms, "
                "dragging moves the map. " +
                stops + "Relief lit from the north-west, contours every " +
                significant(contour_interval(comparison), 2) + " m" +
                (several_files(comparison) ? "; the surface is that of file 1." : ".")) +
          map_figure(comparison));
}

}  // namespace clast::report_detail
