#include "report/maps/qgis_styles.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "report/charts/palette.hpp"
#include "report/html/html_page.hpp"
#include "report/maps/detail/qml.hpp"

namespace clast::report_detail {
namespace {

constexpr const char* kNotAtRest = " (not at rest)";

/// A number from which the same double is read.
std::string exact(double value) { return format_significant(value, 17); }

std::string stops_qml(const Comparison& comparison) {
  const StopMarks stops = choose_stop_marks(comparison);
  const std::string field = stops.by_block ? "\"block\"" : "\"shape\"";
  QmlCategories categories("CASE WHEN \"stop_reason\" = '" + name_of(StopReason::kRest) +
                           "' THEN " + field + " ELSE " + field + " || '" + kNotAtRest + "' END");
  for (const StopMark& mark : stops.marks) {
    categories.add(mark.key,
                   format_qml_marker(categories.next(), mark.shape, mark.colour, "#ffffff", 0.16));
  }
  for (const StopMark& mark : stops.marks) {
    const std::vector<std::size_t>& rows = comparison.groups[mark.group].rows;
    if (std::all_of(rows.begin(), rows.end(), [&](std::size_t row) {
          return comparison.rows[row].record->result.stop_reason == StopReason::kRest;
        })) {
      continue;
    }
    categories.add(mark.key + kNotAtRest, format_qml_marker(categories.next(), mark.shape,
                                                            "255,255,255,0", mark.colour, 0.4));
  }
  return format_qml(categories.renderer());
}

std::set<std::string> shape_classes(const Comparison& comparison) {
  std::set<std::string> classes;
  for (const RunRow& row : comparison.rows) classes.insert(row.block->garcia);
  return classes;
}

std::string crossings_qml(const Comparison& comparison) {
  QmlCategories categories("shape");
  for (const std::string& garcia : shape_classes(comparison)) {
    categories.add(garcia, format_qml_marker(categories.next(), {"", "triangle"},
                                             class_colour(garcia), "#ffffff", 0.16));
  }
  return format_qml(categories.renderer());
}

std::string trajectories_qml(const Comparison& comparison) {
  QmlCategories categories("shape");
  for (const std::string& garcia : shape_classes(comparison)) {
    categories.add(garcia,
                   format_qml_line(categories.next(), class_colour(garcia), 0.3, kPathOpacity));
  }
  return format_qml(categories.renderer());
}

std::string barriers_qml() {
  const std::string labels =
      format_qml_labels("name", 9, {{"placement", "2"}, {"placementFlags", "10"}, {"dist", "1"}});
  return format_qml(format_qml_single_symbol(format_qml_line(0, kBarrierColour, 0.8, 1.0)), labels);
}

}  // namespace

std::string format_raster_qml(const ColourScale& style) {
  std::string items;
  for (std::size_t i = 0; i < style.breaks.size(); ++i) {
    items += format_qml_element("item", {{"value", exact(style.breaks[i])},
                                         {"label", style.label(i)},
                                         {"color", format_colour(style.colours[i])},
                                         {"alpha", "255"}});
  }
  const QmlAttributes range = {{"classificationMin", "0"},
                               {"classificationMax", exact(style.breaks.back())}};
  QmlAttributes shader = {{"colorRampType", "DISCRETE"},
                          {"classificationMode", "1"},
                          {"clip", "0"},
                          {"minimumValue", "0"},
                          {"maximumValue", exact(style.breaks.back())}};
  QmlAttributes renderer = {{"type", "singlebandpseudocolor"},
                            {"band", "1"},
                            {"alphaBand", "-1"},
                            {"opacity", format_fixed(kLayerOpacity, 2)}};
  renderer.insert(renderer.end(), range.begin(), range.end());
  return kQmlHead +
         format_qml_element(
             "qgis", {{"version", "3.22.0"}, {"styleCategories", "Symbology"}},
             "\n" + format_qml_element(
                        "pipe", {},
                        format_qml_element("rasterrenderer", renderer,
                                           format_qml_element("rastershader", {},
                                                              format_qml_element("colorrampshader",
                                                                                 shader, items)))));
}

std::vector<LayerStyle> make_vector_styles(const Comparison& comparison) {
  std::vector<LayerStyle> styles = {{"stops", stops_qml(comparison)},
                                    {"crossings", crossings_qml(comparison)},
                                    {"barriers", barriers_qml()},
                                    {"trajectories", trajectories_qml(comparison)}};
  if (comparison.measured) {
    styles.push_back(
        {"measured", format_qml(format_qml_single_symbol(format_qml_marker(
                         0, kMeasuredStopShape, kMeasuredStopColour, kMeasuredStopColour, 0.5)))});
  }
  return styles;
}

}  // namespace clast::report_detail
