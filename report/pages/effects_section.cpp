#include <algorithm>

#include "report/charts/form_responses.hpp"
#include "report/html/html_page.hpp"
#include "report/pages/report_groups.hpp"
#include "report/pages/report_sections.hpp"
#include "report/text/effects_text.hpp"
#include "report/text/trends_text.hpp"

namespace clast::report_detail {
namespace {

/// Pictures of the outcomes over the forms, each with a link to a file of its own.
std::string triangles(const ComparisonAnalyses& analyses) {
  const std::vector<ResponseDiagram> pictures =
      draw_response_diagrams(analyses.shape_outcomes(), has_several_files(analyses.comparison()));
  if (pictures.empty()) return "";
  std::string html, links;
  for (const ResponseDiagram& picture : pictures) {
    html += format_figure(picture.svg, picture.caption);
    links += (links.empty() ? "" : ", ") + ("<a href=\"" + format_link_target(picture.file) +
                                            "\" download>" + escape_html(picture.file) + "</a>");
  }
  return html +
         "<p>The surface passes through the mean outcome of every form. Image files: " + links +
         "; data: <a href=\"responses.csv\" download>responses.csv</a>.</p>\n";
}

std::string trends(const ComparisonAnalyses& analyses) {
  std::string html;
  for (const std::string& sentence :
       describe_trends(analyses.shape_trends(), analyses.comparison().margin)) {
    html += format_paragraph(sentence);
  }
  return html;
}

/// Minimum number of blocks for meaningful intervals of fractions.
constexpr std::size_t kMinBlocksForIntervals = 6;

/// True if no file has enough levels of its first factor, blocks or forms.
bool few_blocks(const std::vector<DesignEffects>& effects) {
  return std::all_of(effects.begin(), effects.end(), [](const DesignEffects& file) {
    return file.factors.empty() || file.factors.front().levels < kMinBlocksForIntervals;
  });
}

}  // namespace

std::string format_effects_section(const ComparisonAnalyses& analyses) {
  std::vector<DesignEffects> effects = analyses.design_effects();
  bool any = false;
  for (DesignEffects& file : effects) {
    const bool has_forms = file.factors.size() > 1 && !file.outcomes.empty();
    any = any || has_forms;
    file.refusal_reason.clear();  // most campaigns are no such design, and need not be
  }
  if (!any) return "";
  std::string shares;
  for (const std::string& sentence : describe_effects(effects))
    shares += format_paragraph(sentence);
  shares += format_paragraph(
      "The fractions of the variance are estimates for blocks, orientations and release points "
      "like these, with 95 % intervals.");
  if (few_blocks(effects)) {
    shares = format_paragraph(
                 "There are too few blocks to estimate how much of the variance between runs is "
                 "explained by the block and how much by its orientation at release.") +
             format_folded_section("Fractions of the variance", shares);
  }
  return format_section("Sources of variability", shares + triangles(analyses) + trends(analyses));
}

}  // namespace clast::report_detail
