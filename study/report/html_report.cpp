#include "study/report/html_report.hpp"

#include "study/report/page_script.hpp"
#include "study/report/plotly_chart.hpp"
#include "study/report/report_page.hpp"
#include "study/report/report_sections.hpp"
#include "study/report/scene_section.hpp"

namespace clast {

std::string html_report(const Comparison& comparison, const std::vector<ProfileBin>& bins) {
  std::string title = "Rockfall report";
  const std::string file = comparison.results.front().file.stem().string();
  if (!file.empty()) title += ": " + file;
  if (comparison.results.size() > 1) {
    title += " and " + std::to_string(comparison.results.size() - 1) + " more";
  }
  return report_page(title, unpack_script() + head_section(comparison) + class_section(comparison) +
                                map_section(comparison) + scene_section(comparison) +
                                runout_section(comparison) + slope_section(comparison, bins) +
                                differences_section(comparison) + barrier_section(comparison) +
                                block_section(comparison) + quality_section(comparison) +
                                provenance_section(comparison) + charts_script());
}

}  // namespace clast
