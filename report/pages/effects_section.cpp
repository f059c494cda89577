#include "report/html/html_page.hpp"
#include "report/pages/report_groups.hpp"
#include "report/pages/report_sections.hpp"
#include "report/text/effects_text.hpp"

namespace clast::report_detail {

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
  return section("What the variance is due to",
                 sentences + paragraph("Every combination was run once. Shares are estimates for "
                                       "blocks, orientations and points like these, with 95 % "
                                       "intervals; those of these runs alone are in effects.csv."));
}

}  // namespace clast::report_detail
