#include "report/maps/page_map.hpp"

#include <cmath>

#include "report/charts/plotly_chart.hpp"
#include "report/html/assets.hpp"
#include "report/html/html_page.hpp"
#include "report/html/page_script.hpp"
#include "report/maps/detail/map_layers.hpp"
#include "report/maps/detail/map_traces.hpp"
#include "report/maps/map_marks.hpp"
#include "report/maps/map_style.hpp"

namespace clast::report_detail {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::uint32_t kReliefColumns = 1000;

Json axis(const char* name, double low, double high) {
  const auto on_map = [](double value) { return std::round(100.0 * value) / 100.0; };
  return {{"title", {{"text", name}}},
          {"range", {on_map(low), on_map(high)}},
          {"ticks", ""},
          {"constrain", "domain"},  // the frame goes round the window, not farther
          {"exponentformat", "none"},
          {"tickformat", ".12~g"},
          {"gridcolor", "rgba(255,255,255,.45)"},
          {"zeroline", false}};
}

Json layout_of(const SiteMap& site, int height, const Json& notes) {
  const PlanWindow& window = site.window;
  Json y = axis("y, m", window.low.y(), window.high.y());
  y["scaleanchor"] = "x";
  return {
      // the buttons alone fill the margin above; there is no title
      {"height", height},
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
       {{{"source", draw_relief_image(site, kReliefColumns)},
         {"xref", "x"},
         {"yref", "y"},
         {"x", window.low.x()},
         {"y", window.high.y()},
         {"sizex", window.size().x()},
         {"sizey", window.size().y()},
         {"sizing", "stretch"},
         {"layer", "below"}}}}};
}

/// Formats the selectable contents as options of a list.
std::string choices(const PageMapContents& contents) {
  std::string options;
  const auto add = [&](const std::string& value, const std::string& text) {
    options += "<option value=\"" + escape_html(value) + "\">" + escape_html(text) + "</option>\n";
  };
  if (contents.marks) add("stops", "stops");
  for (const MapRasterSet* rasters : contents.rasters) {
    const std::vector<ColourScale> styles = choose_colour_scales(*rasters);
    for (std::size_t i = 0; i < styles.size(); ++i) {
      const std::string unit = styles[i].unit.empty() ? "" : ", " + styles[i].unit;
      add(rasters->layers[i].name, styles[i].title + unit);
    }
  }
  return options;
}

std::string paths_box(const MapLayerData& layers) {
  if (layers.paths == 0) return {};
  const std::string count =
      layers.paths == layers.stored_paths
          ? std::to_string(layers.paths)
          : std::to_string(layers.paths) + " of " + std::to_string(layers.stored_paths);
  return "<label><input type=\"checkbox\" data-map=\"paths\"> paths (" + count + ")</label>\n";
}

}  // namespace

std::string format_page_map(const Comparison& comparison, const PageMapContents& contents) {
  const std::string options = choices(contents);
  if (options.empty() || !plotly_is_installed()) return {};
  const SiteMap site = make_site_map(comparison);
  const MapLayerData layers =
      make_map_layer_data(comparison, contents.rasters, site.window.low, contents.marks);
  Json traces = Json::array(), notes = Json::array();
  if (contents.marks) add_stop_traces(comparison, site.window, traces);
  add_barrier_traces(site, traces, notes);
  if (contents.marks) {
    add_release_traces(site, traces);
    add_zone_traces(site, traces);
  }
  const Json figure = {{"data", traces},
                       {"layout", layout_of(site, contents.height, notes)},
                       {"config", {{"scrollZoom", true}}}};
  return fill_template(
      assets::map_html,
      {{"id", contents.id},
       {"choices", options},
       {"opacity", format_decimals(kLayerOpacity, 2)},
       {"paths", paths_box(layers)},
       {"figure",
        format_plotly_figure(contents.label, "map",
                             figure.dump(-1, ' ', false, Json::error_handler_t::replace))},
       {"data", format_packed_element(contents.id, layers.json)}});
}

}  // namespace clast::report_detail
