#include "report/maps/qgis_styles.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "report/charts/palette.hpp"
#include "report/html/html_page.hpp"

namespace clast::report_detail {
namespace {

constexpr const char* kHead = "<!DOCTYPE qgis PUBLIC 'http://mrcc.com/qgis.dtd' 'SYSTEM'>\n";
constexpr const char* kNotAtRest = " (not at rest)";

using Attributes = std::vector<std::pair<std::string, std::string>>;

/// "<name key="value">inside</name>"
std::string element(const std::string& name, const Attributes& attributes,
                    const std::string& inside = {}) {
  std::string xml = "<" + name;
  for (const auto& [key, value] : attributes) xml += " " + key + "=\"" + escape_html(value) + "\"";
  return xml + (inside.empty() ? "/>\n" : ">" + inside + "</" + name + ">\n");
}

/// A number from which the same double is read.
std::string exact(double value) { return format_significant(value, 17); }

/// One symbol layer, with its properties as every QGIS 3 reads them.
std::string symbol(const std::string& type, std::size_t number, double opacity,
                   const std::string& layer_class, const Attributes& properties) {
  std::string props;
  for (const auto& [key, value] : properties) props += element("prop", {{"k", key}, {"v", value}});
  return element(
      "symbol",
      {{"type", type},
       {"name", std::to_string(number)},
       {"alpha", format_fixed(opacity, 2)},
       {"clip_to_extent", "1"},
       {"force_rhr", "0"}},
      element("layer", {{"class", layer_class}, {"enabled", "1"}, {"pass", "0"}, {"locked", "0"}},
              props));
}

std::string marker(std::size_t number, const MarkShape& shape, const std::string& fill,
                   const std::string& outline, double outline_mm) {
  return symbol("marker", number, 1.0, "SimpleMarker",
                {{"name", shape.qgis},
                 {"angle", std::to_string(shape.qgis_angle)},
                 {"color", fill},
                 {"outline_color", outline},
                 {"outline_width", format_fixed(outline_mm, 2)},
                 {"outline_width_unit", "MM"},
                 {"size", "2.4"},
                 {"size_unit", "MM"}});
}

std::string line(std::size_t number, const std::string& colour, double width_mm, double opacity) {
  return symbol("line", number, opacity, "SimpleLine",
                {{"line_color", colour},
                 {"line_width", format_fixed(width_mm, 2)},
                 {"line_width_unit", "MM"},
                 {"capstyle", "round"},
                 {"joinstyle", "round"}});
}

std::string qml(const std::string& renderer, const std::string& labels = {}) {
  return kHead + element("qgis",
                         {{"version", "3.22.0"},
                          {"styleCategories", "Symbology|Labeling"},
                          {"labelsEnabled", labels.empty() ? "0" : "1"}},
                         "\n" + renderer + labels);
}

std::string single_symbol(const std::string& only) {
  return element("renderer-v2", {{"type", "singleSymbol"}}, element("symbols", {}, only));
}

/// Symbols by the value of a field or an expression.
class Categories {
 public:
  explicit Categories(std::string attribute) : attribute_(std::move(attribute)) {}

  std::size_t next() const { return count_; }
  void add(const std::string& value, const std::string& symbol) {
    categories_ += element("category", {{"value", value},
                                        {"label", value},
                                        {"symbol", std::to_string(count_++)},
                                        {"render", "true"}});
    symbols_ += symbol;
  }
  std::string renderer() const {
    return element("renderer-v2", {{"type", "categorizedSymbol"}, {"attr", attribute_}},
                   element("categories", {}, categories_) + element("symbols", {}, symbols_));
  }

 private:
  std::string attribute_, categories_, symbols_;
  std::size_t count_ = 0;
};

std::string stops_qml(const Comparison& comparison) {
  const StopMarks stops = choose_stop_marks(comparison);
  const std::string field = stops.by_block ? "\"block\"" : "\"shape\"";
  Categories categories("CASE WHEN \"stop_reason\" = '" + name_of(StopReason::kRest) + "' THEN " +
                        field + " ELSE " + field + " || '" + kNotAtRest + "' END");
  for (const StopMark& mark : stops.marks) {
    categories.add(mark.key, marker(categories.next(), mark.shape, mark.colour, "#ffffff", 0.16));
  }
  for (const StopMark& mark : stops.marks) {
    const std::vector<std::size_t>& rows = comparison.groups[mark.group].rows;
    if (std::all_of(rows.begin(), rows.end(), [&](std::size_t row) {
          return comparison.rows[row].record->result.stop_reason == StopReason::kRest;
        })) {
      continue;
    }
    categories.add(mark.key + kNotAtRest,
                   marker(categories.next(), mark.shape, "255,255,255,0", mark.colour, 0.4));
  }
  return qml(categories.renderer());
}

std::set<std::string> shape_classes(const Comparison& comparison) {
  std::set<std::string> classes;
  for (const RunRow& row : comparison.rows) classes.insert(row.block->garcia);
  return classes;
}

std::string crossings_qml(const Comparison& comparison) {
  Categories categories("shape");
  for (const std::string& garcia : shape_classes(comparison)) {
    categories.add(
        garcia, marker(categories.next(), {"", "triangle"}, class_colour(garcia), "#ffffff", 0.16));
  }
  return qml(categories.renderer());
}

std::string trajectories_qml(const Comparison& comparison) {
  Categories categories("shape");
  for (const std::string& garcia : shape_classes(comparison)) {
    categories.add(garcia, line(categories.next(), class_colour(garcia), 0.3, kPathOpacity));
  }
  return qml(categories.renderer());
}

std::string barriers_qml() {
  const std::string halo = element("text-buffer", {{"bufferDraw", "1"},
                                                   {"bufferSize", "0.8"},
                                                   {"bufferSizeUnits", "MM"},
                                                   {"bufferColor", "255,255,255,255"},
                                                   {"bufferOpacity", "1"}});
  const std::string text = element("text-style",
                                   {{"fieldName", "name"},
                                    {"isExpression", "0"},
                                    {"fontSize", "9"},
                                    {"fontSizeUnit", "Point"},
                                    {"fontWeight", "75"},
                                    {"textColor", "17,17,17,255"},
                                    {"textOpacity", "1"}},
                                   halo);
  const std::string above_the_line =
      element("placement", {{"placement", "2"}, {"placementFlags", "10"}, {"dist", "1"}});
  const std::string labels =
      element("labeling", {{"type", "simple"}}, element("settings", {}, text + above_the_line));
  return qml(single_symbol(line(0, kBarrierColour, 0.8, 1.0)), labels);
}

}  // namespace

std::string format_raster_qml(const ColourScale& style) {
  std::string items;
  for (std::size_t i = 0; i < style.breaks.size(); ++i) {
    items += element("item", {{"value", exact(style.breaks[i])},
                              {"label", style.label(i)},
                              {"color", format_colour(style.colours[i])},
                              {"alpha", "255"}});
  }
  const Attributes range = {{"classificationMin", "0"},
                            {"classificationMax", exact(style.breaks.back())}};
  Attributes shader = {{"colorRampType", "DISCRETE"},
                       {"classificationMode", "1"},
                       {"clip", "0"},
                       {"minimumValue", "0"},
                       {"maximumValue", exact(style.breaks.back())}};
  Attributes renderer = {{"type", "singlebandpseudocolor"},
                         {"band", "1"},
                         {"alphaBand", "-1"},
                         {"opacity", format_fixed(kLayerOpacity, 2)}};
  renderer.insert(renderer.end(), range.begin(), range.end());
  return kHead +
         element("qgis", {{"version", "3.22.0"}, {"styleCategories", "Symbology"}},
                 "\n" + element("pipe", {},
                                element("rasterrenderer", renderer,
                                        element("rastershader", {},
                                                element("colorrampshader", shader, items)))));
}

std::vector<LayerStyle> make_vector_styles(const Comparison& comparison) {
  std::vector<LayerStyle> styles = {{"stops", stops_qml(comparison)},
                                    {"crossings", crossings_qml(comparison)},
                                    {"barriers", barriers_qml()},
                                    {"trajectories", trajectories_qml(comparison)}};
  if (comparison.measured) {
    styles.push_back(
        {"measured", qml(single_symbol(marker(0, kMeasuredStopShape, kMeasuredStopColour,
                                              kMeasuredStopColour, 0.5)))});
  }
  return styles;
}

}  // namespace clast::report_detail
