#pragma once
/// An outcome over the triangle of Sneed and Folk.
#include <span>
#include <string>

#include "classify/form.hpp"

namespace clast::report_detail {

/// The outcome of one form.
struct ShapeResponse {
  std::string name;
  Axes axes;
  double value = 0.0;
  bool marked = false;
};

/// SVG: a surface through the values of all forms (charts/contour_field.hpp) as coloured bands with
/// contour lines at round values, within the forms; compact at the top, platy left, elongate right.
/// A small disc for each form shows its own value; forms that are `marked`, scanned blocks among
/// forms made of one, are larger and named. Where the forms lie on one line, discs alone, coloured
/// from the smallest value to the largest.
/// @param label  what is shown: "mean runout, m"
/// @cite sneed1958
std::string draw_response_triangle(std::span<const ShapeResponse> forms, const std::string& label);

}  // namespace clast::report_detail
