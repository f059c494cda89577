#include "report/maps/detail/qml.hpp"

#include "report/html/html_page.hpp"

namespace clast::report_detail {
namespace {

/// One symbol layer, with its properties as every QGIS 3 reads them.
std::string format_qml_symbol(const std::string& type, std::size_t number, double opacity,
                              const std::string& layer_class, const QmlAttributes& properties) {
  std::string props;
  for (const auto& [key, value] : properties) {
    props += format_qml_element("prop", {{"k", key}, {"v", value}});
  }
  return format_qml_element(
      "symbol",
      {{"type", type},
       {"name", std::to_string(number)},
       {"alpha", format_fixed(opacity, 2)},
       {"clip_to_extent", "1"},
       {"force_rhr", "0"}},
      format_qml_element("layer",
                         {{"class", layer_class}, {"enabled", "1"}, {"pass", "0"}, {"locked", "0"}},
                         props));
}

}  // namespace

std::string format_qml_element(const std::string& name, const QmlAttributes& attributes,
                               const std::string& inside) {
  std::string xml = "<" + name;
  for (const auto& [key, value] : attributes) xml += " " + key + "=\"" + escape_html(value) + "\"";
  return xml + (inside.empty() ? "/>\n" : ">" + inside + "</" + name + ">\n");
}

std::string format_qml_marker(std::size_t number, const MarkShape& shape, const std::string& fill,
                              const std::string& outline, double outline_mm) {
  return format_qml_symbol("marker", number, 1.0, "SimpleMarker",
                           {{"name", shape.qgis},
                            {"angle", std::to_string(shape.qgis_angle)},
                            {"color", fill},
                            {"outline_color", outline},
                            {"outline_width", format_fixed(outline_mm, 2)},
                            {"outline_width_unit", "MM"},
                            {"size", "2.4"},
                            {"size_unit", "MM"}});
}

std::string format_qml_line(std::size_t number, const std::string& colour, double width_mm,
                            double opacity) {
  return format_qml_symbol("line", number, opacity, "SimpleLine",
                           {{"line_color", colour},
                            {"line_width", format_fixed(width_mm, 2)},
                            {"line_width_unit", "MM"},
                            {"capstyle", "round"},
                            {"joinstyle", "round"}});
}

std::string format_qml_fill(std::size_t number, const std::string& fill, const std::string& outline,
                            double outline_mm) {
  return format_qml_symbol("fill", number, 1.0, "SimpleFill",
                           {{"style", "solid"},
                            {"color", fill},
                            {"outline_style", "solid"},
                            {"outline_color", outline},
                            {"outline_width", format_fixed(outline_mm, 2)},
                            {"outline_width_unit", "MM"},
                            {"joinstyle", "round"}});
}

std::string format_qml(const std::string& renderer, const std::string& labels) {
  return kQmlHead + format_qml_element("qgis",
                                       {{"version", "3.22.0"},
                                        {"styleCategories", "Symbology|Labeling"},
                                        {"labelsEnabled", labels.empty() ? "0" : "1"}},
                                       "\n" + renderer + labels);
}

std::string format_qml_single_symbol(const std::string& symbol) {
  return format_qml_element("renderer-v2", {{"type", "singleSymbol"}},
                            format_qml_element("symbols", {}, symbol));
}

std::string format_qml_labels(const std::string& field, int points,
                              const QmlAttributes& placement) {
  const std::string halo = format_qml_element("text-buffer", {{"bufferDraw", "1"},
                                                              {"bufferSize", "0.8"},
                                                              {"bufferSizeUnits", "MM"},
                                                              {"bufferColor", "255,255,255,255"},
                                                              {"bufferOpacity", "1"}});
  const std::string text = format_qml_element("text-style",
                                              {{"fieldName", field},
                                               {"isExpression", "0"},
                                               {"fontSize", std::to_string(points)},
                                               {"fontSizeUnit", "Point"},
                                               {"fontWeight", "75"},
                                               {"textColor", "17,17,17,255"},
                                               {"textOpacity", "1"}},
                                              halo);
  return format_qml_element(
      "labeling", {{"type", "simple"}},
      format_qml_element("settings", {}, text + format_qml_element("placement", placement)));
}

void QmlCategories::add(const std::string& value, const std::string& symbol) {
  categories_ += format_qml_element("category", {{"value", value},
                                                 {"label", value},
                                                 {"symbol", std::to_string(count_++)},
                                                 {"render", "true"}});
  symbols_ += symbol;
}

std::string QmlCategories::renderer() const {
  return format_qml_element("renderer-v2", {{"type", "categorizedSymbol"}, {"attr", attribute_}},
                            format_qml_element("categories", {}, categories_) +
                                format_qml_element("symbols", {}, symbols_));
}

}  // namespace clast::report_detail
