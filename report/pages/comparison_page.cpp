#include "report/pages/comparison_page.hpp"

#include "report/charts/plotly_chart.hpp"
#include "report/html/assets.hpp"
#include "report/html/contents_list.hpp"
#include "report/html/page_script.hpp"
#include "report/html/report_page.hpp"
#include "report/html/terms.hpp"
#include "report/pages/report_sections.hpp"
#include "report/scene/scene_section.hpp"

namespace clast::report_detail {

std::string make_comparison_page(const ComparisonAnalyses& analyses) {
  const Comparison& comparison = analyses.comparison();
  std::string title = "Rockfall report";
  const std::string file = comparison.results.front().file.stem().string();
  if (!file.empty()) title += ": " + file;
  if (comparison.results.size() > 1) {
    title += " and " + std::to_string(comparison.results.size() - 1) + " more";
  }
  const std::string sections = link_glossary_terms(
      "<div class=\"opening\">\n" + format_head_section(comparison, analyses.key_results()) +
      format_map_section(comparison, analyses.path_rasters(), analyses.deposit_results().rasters) +
      "</div>\n" + format_class_section(comparison) + format_differences_section(comparison) +
      format_measured_section(comparison) + format_runout_section(comparison) +
      format_barrier_section(analyses) + format_slope_section(comparison, analyses.profiles()) +
      format_deposit_section(analyses) + format_energy_section(analyses) +
      format_persistent_blocks_section(comparison) + format_ensemble_section(analyses) +
      format_effects_section(analyses) + format_scene_section(comparison) +
      format_block_section(comparison) + format_quality_section(comparison) +
      format_provenance_section(comparison));
  return make_report_page(title, format_script_element(assets::unpack_js) +
                                     make_contents_list(sections) + sections + charts_script());
}

}  // namespace clast::report_detail
