#pragma once
/// Pictures of what the forms of a campaign came to, over the triangle of Sneed and Folk.
#include <string>
#include <vector>

#include "study/compare/form_outcomes.hpp"

namespace clast::report_detail {

/// A picture of the mean of an outcome over the triangle, and the file name it is kept by:
/// "response_runout.svg"; of several files "response_2_runout.svg". Empty where all forms have the
/// same mean.
struct ResponseFigure {
  std::string file;
  std::string caption;
  std::string svg;
};
std::vector<ResponseFigure> draw_response_figures(const std::vector<OutcomeByShape>& outcomes,
                                               bool several_files);

}  // namespace clast::report_detail
