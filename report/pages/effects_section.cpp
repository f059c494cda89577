#include <map>
#include <utility>

#include "core/statistics.hpp"
#include "report/charts/response_triangle.hpp"
#include "report/html/html_page.hpp"
#include "report/pages/report_groups.hpp"
#include "report/pages/report_sections.hpp"
#include "report/text/effects_text.hpp"
#include "report/text/trends_text.hpp"

namespace clast::report_detail {
namespace {

/// Fewer forms make no surface.
constexpr std::size_t kFewestForms = 6;

/// Mean runout of each form of a file, over all its runs.
std::vector<FormResponse> runout_of_forms(const Comparison& comparison, std::uint32_t file) {
  std::map<std::string, std::pair<const BlockSummary*, std::vector<double>>> forms;
  for (const RunRow& row : comparison.rows) {
    if (row.file != file) continue;
    auto& [block, runouts] = forms[row.block->library_block()];
    block = row.block;
    runouts.push_back(row.runout);
  }
  std::vector<FormResponse> responses;
  for (const auto& [name, form] : forms) {
    responses.push_back({name, form.first->axes, summarise(form.second).mean});
  }
  return responses;
}

std::string triangles(const Comparison& comparison, const std::vector<DesignEffects>& effects) {
  std::string html;
  for (const DesignEffects& file : effects) {
    if (file.outcomes.empty()) continue;
    const std::vector<FormResponse> forms = runout_of_forms(comparison, file.file);
    if (forms.size() < kFewestForms) continue;
    const std::string of =
        several_files(comparison) ? " of file " + std::to_string(file.file + 1) : std::string();
    html += figure(response_triangle(forms, "mean runout, m"),
                   "Mean runout" + of + ", m, over the triangle of Sneed and Folk");
  }
  return html;
}

std::string trends(const Comparison& comparison) {
  std::string html;
  for (const std::string& sentence : trend_sentences(shape_trends(comparison), comparison.margin)) {
    html += paragraph(sentence);
  }
  return html;
}

}  // namespace

std::string effects_section(const Comparison& comparison) {
  std::vector<DesignEffects> effects = design_effects(comparison);
  bool any = false;
  for (DesignEffects& file : effects) {
    any = any || !file.outcomes.empty();
    file.refusal.clear();  // most campaigns are no such design, and need not be
  }
  if (!any) return "";
  std::string sentences;
  for (const std::string& sentence : effects_sentences(effects)) sentences += paragraph(sentence);
  return section("Sources of variability",
                 sentences + triangles(comparison, effects) + trends(comparison) +
                     paragraph("Every combination was run once. Shares are estimates for "
                               "blocks, orientations and points like these, with 95 % "
                               "intervals; those of these runs alone are in effects.csv."));
}

}  // namespace clast::report_detail
