#include "report/pages/comparison_page.hpp"

#include "report/charts/plotly_chart.hpp"
#include "report/html/assets.hpp"
#include "report/html/contents.hpp"
#include "report/html/page_script.hpp"
#include "report/html/report_page.hpp"
#include "report/html/terms.hpp"
#include "report/pages/report_sections.hpp"
#include "report/scene/scene_section.hpp"

namespace clast::report_detail {

std::string comparison_page(const ComparisonAnalyses& analyses) {
  const Comparison& comparison = analyses.comparison();
  std::string title = "Rockfall report";
  const std::string file = comparison.results.front().file.stem().string();
  if (!file.empty()) title += ": " + file;
  if (comparison.results.size() > 1) {
    title += " and " + std::to_string(comparison.results.size() - 1) + " more";
  }
  const std::string sections = with_terms(
      "<div class=\"opening\">\n" + head_section(comparison, analyses.answer()) +
      map_section(comparison, analyses.paths(), analyses.deposits().rasters) + "</div>\n" +
      class_section(comparison) + differences_section(comparison) + measured_section(comparison) +
      runout_section(comparison) + barrier_section(analyses) +
      slope_section(comparison, analyses.profiles()) + deposit_section(analyses) +
      energy_section(analyses) + stay_section(comparison) + ensemble_section(analyses) +
      effects_section(analyses) + scene_section(comparison) + block_section(comparison) +
      quality_section(comparison) + provenance_section(comparison));
  return report_page(
      title, script_element(assets::unpack_js) + contents(sections) + sections + charts_script());
}

}  // namespace clast::report_detail
