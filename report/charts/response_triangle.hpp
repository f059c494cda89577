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
  bool marked = false;  ///< true: has a larger mark with a label
};

/// Draws a surface through the values of all shapes (charts/contour_field.hpp) as coloured bands
/// with contour lines at round values, within the convex hull of the shapes. Compact shapes are at
/// the top, platy shapes left, elongate shapes right. Each shape has a disc in the colour of its
/// value. `marked` shapes, such as scanned blocks, have larger discs with labels. If the shapes are
/// collinear, only discs are drawn.
/// @param label  quantity with unit, such as "mean runout, m"
/// @cite sneed1958
std::string draw_response_triangle(std::span<const ShapeResponse> forms, const std::string& label);

}  // namespace clast::report_detail
