#pragma once
/// An outcome over the triangle of Sneed and Folk.
#include <span>
#include <string>

#include "classify/form.hpp"

namespace clast::report_detail {

/// The outcome of one form.
struct FormResponse {
  std::string name;
  Axes axes;
  double value = 0.0;
};

/// SVG: a disc for each form, compact at the top, platy left, elongate right, coloured from the
/// smallest value to the largest, with its value in it.
/// @param label  what is shown: "mean runout, m"
/// @cite sneed1958
std::string response_triangle(std::span<const FormResponse> forms, const std::string& label);

}  // namespace clast::report_detail
