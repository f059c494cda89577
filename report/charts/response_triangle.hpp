#pragma once
/// Outcome over the Sneed-Folk triangle.
#include <span>
#include <string>

#include "classify/form.hpp"

namespace clast::report_detail {

struct ShapeResponse {
  std::string name;
  Axes axes;
  double value = 0.0;
  bool marked = false;  ///< larger, labelled mark
};

/// Draws an interpolated surface through the values of all forms (charts/contour_field.hpp) as
/// coloured bands with contour lines at round values, within the convex hull of the forms; compact
/// at the top, platy left, elongate right. Each form has a small disc in the colour of its value;
/// `marked` forms, such as scanned blocks, are larger and labelled. If the forms are collinear,
/// only discs are drawn.
/// @param label  quantity with unit: "mean runout, m"
/// @cite sneed1958
std::string draw_response_triangle(std::span<const ShapeResponse> forms, const std::string& label);

}  // namespace clast::report_detail
