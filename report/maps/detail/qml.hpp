#pragma once
/// Elements of QGIS 3 layer styles (QML).
#include <string>
#include <utility>
#include <vector>

#include "report/maps/mark_shape.hpp"

namespace clast::report_detail {

/// First line of a style file.
inline constexpr const char* kQmlHead =
    "<!DOCTYPE qgis PUBLIC 'http://mrcc.com/qgis.dtd' 'SYSTEM'>\n";

using QmlAttributes = std::vector<std::pair<std::string, std::string>>;

/// Formats an element: "<name key="value">inside</name>".
std::string format_qml_element(const std::string& name, const QmlAttributes& attributes,
                               const std::string& inside = {});

/// Formats a marker symbol. Colours are "#rrggbb" or "r,g,b,a".
/// @param number  name of the symbol in its renderer
std::string format_qml_marker(std::size_t number, const MarkShape& shape, const std::string& fill,
                              const std::string& outline, double outline_mm);
std::string format_qml_line(std::size_t number, const std::string& colour, double width_mm,
                            double opacity);
/// Formats an area symbol with an opaque outline.
/// @param fill  "r,g,b,a"
std::string format_qml_fill(std::size_t number, const std::string& fill, const std::string& outline,
                            double outline_mm);

/// Formats a layer style.
/// @param labels  result of `format_qml_labels`; empty: no labels
std::string format_qml(const std::string& renderer, const std::string& labels = {});

/// Formats a renderer that draws all features with one symbol.
std::string format_qml_single_symbol(const std::string& symbol);

/// Formats labels with the value of a field, in black with a white halo.
/// @param points  size of the letters
std::string format_qml_labels(const std::string& field, int points, const QmlAttributes& placement);

/// Symbols by the value of a field or an expression.
class QmlCategories {
 public:
  explicit QmlCategories(std::string attribute) : attribute_(std::move(attribute)) {}

  std::size_t next() const { return count_; }  ///< number of the next symbol
  void add(const std::string& value, const std::string& symbol);
  std::string renderer() const;

 private:
  std::string attribute_, categories_, symbols_;
  std::size_t count_ = 0;
};

}  // namespace clast::report_detail
