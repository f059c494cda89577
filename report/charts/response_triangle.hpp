#pragma once
/// Diagram of an outcome over the Sneed-Folk triangle.
#include <span>
#include <string>

#include "classify/form.hpp"

namespace clast::report_detail {

struct ShapeResponse {
  std::string name;
  Axes axes;
  double value = 0.0;
  bool marked = false;  ///< true if the mark is larger and has a label
};

/// Draws an outcome over the Sneed-Folk triangle: a smooth surface through the values of all shapes
/// as coloured bands with contour lines. Each shape has a disc in the colour of its value. `marked`
/// shapes have larger discs with labels.
/// @param label  quantity with unit, such as "mean runout, m"
/// @cite sneed1958
std::string draw_response_triangle(std::span<const ShapeResponse> forms, const std::string& label);

}  // namespace clast::report_detail
