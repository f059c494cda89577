#pragma once
/// Diagrams of mean outcomes over the Sneed-Folk triangle.
#include <string>
#include <vector>

#include "study/compare/form_outcomes.hpp"

namespace clast::report_detail {

/// Diagram of a mean outcome over the triangle, with its file name. Names are
/// "response_runout.svg", or "response_2_runout.svg" if there are several results files.
struct ResponseDiagram {
  std::string file;
  std::string caption;
  std::string svg;
};
/// Draws the diagrams of all outcomes that vary between shapes.
std::vector<ResponseDiagram> draw_response_diagrams(const std::vector<OutcomeByShape>& outcomes,
                                                    bool several_files);

}  // namespace clast::report_detail
