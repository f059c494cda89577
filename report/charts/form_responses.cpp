#include "report/charts/form_responses.hpp"

#include <algorithm>
#include <cctype>

#include "report/charts/response_triangle.hpp"
#include "report/text/capital.hpp"

namespace clast::report_detail {
namespace {

/// Letters and digits alone.
std::string as_file_name(const std::string& text) {
  std::string name;
  for (const char c : text) name += std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
  return name;
}

}  // namespace

std::vector<ResponseDiagram> draw_response_diagrams(const std::vector<OutcomeByShape>& outcomes,
                                                    bool several_files) {
  std::vector<ResponseDiagram> pictures;
  for (const OutcomeByShape& outcome : outcomes) {
    if (outcome.outcome == "lateral angle" || outcome.outcome == "largest energy") continue;
    const bool any_made = std::any_of(outcome.forms.begin(), outcome.forms.end(),
                                      [](const ShapeOutcome& form) { return form.is_generated; });
    std::vector<ShapeResponse> forms;
    for (const ShapeOutcome& form : outcome.forms) {
      forms.push_back({form.block_id, form.axes, form.mean, any_made && !form.is_generated});
    }
    const auto [minimum, maximum] = std::minmax_element(
        forms.begin(), forms.end(),
        [](const ShapeResponse& a, const ShapeResponse& b) { return a.value < b.value; });
    if (minimum->value == maximum->value) continue;
    const std::string number = several_files ? std::to_string(outcome.file + 1) + "_" : "";
    const std::string label = outcome.unit.empty()
                                  ? "fraction " + outcome.outcome
                                  : "mean " + outcome.outcome + ", " + outcome.unit;
    const std::string of =
        several_files ? " of file " + std::to_string(outcome.file + 1) : std::string();
    pictures.push_back({"response_" + number + as_file_name(outcome.outcome) + ".svg",
                        capitalized(label) + of + ", over the triangle of Sneed and Folk",
                        draw_response_triangle(forms, label)});
  }
  return pictures;
}

}  // namespace clast::report_detail
