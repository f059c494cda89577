#pragma once
/// Diagrams of mean outcomes over the Sneed-Folk triangle.
#include <string>
#include <vector>

#include "study/compare/form_outcomes.hpp"

namespace clast::report_detail {

/// Diagram of a mean outcome over the Sneed-Folk triangle, with its file name and caption.
struct ResponseDiagram {
  std::string file;
  std::string caption;
  std::string svg;
};
/// Draws the diagrams of all outcomes that vary between block shapes.
std::vector<ResponseDiagram> draw_response_diagrams(const std::vector<OutcomeByShape>& outcomes,
                                                    bool several_files);

}  // namespace clast::report_detail
