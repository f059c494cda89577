#include "report/scene/scene_section.hpp"

#include <set>

#include "report/charts/palette.hpp"
#include "report/html/assets.hpp"
#include "report/html/html_page.hpp"
#include "report/html/page_script.hpp"
#include "report/scene/three_library.hpp"

namespace clast::report_detail {
namespace {

/// The view with its controls: the time, and check boxes that hide classes.
std::string scene_view(const Comparison& comparison) {
  std::set<std::string> classes;
  for (const RunRow& row : comparison.rows) classes.insert(row.block->garcia);
  std::string boxes;
  for (const std::string& name : classes) {
    boxes += "<label><input type=\"checkbox\" checked data-group=\"" + escape_html(name) +
             "\"><span style=\"color:" + class_colour(name) + "\">\xE2\x97\x8F</span> " +
             escape_html(name) + "</label>\n";
  }
  return fill_template(assets::scene_html, {{"classes", boxes}});
}

}  // namespace

std::string format_scene_section(const Comparison& comparison, const SceneLimits& limits) {
  const std::string title = "3-D view";
  if (!three_is_installed())
    return format_section(title, format_paragraph(explain_missing_three("compare again")));
  const SceneData data = make_scene_data(comparison, limits);
  if (data.runs_drawn == 0) {
    return format_section(
        title, format_paragraph("The results contain no trajectories; set [run] "
                                "trajectory_interval_s above zero to see the blocks move."));
  }
  const std::string drawn =
      data.runs_drawn == data.runs
          ? "All " + std::to_string(data.runs) + " runs are drawn."
          : std::to_string(data.runs_drawn) + " of " + std::to_string(data.runs) +
                " runs are drawn, one in " +
                std::to_string((data.runs + data.runs_drawn - 1) / data.runs_drawn) + ".";
  return format_section(
             title,
             format_paragraph(
                 "Drag to rotate, use the wheel to zoom, drag with the right button to move. " +
                 drawn + " Positions between stored states are interpolated.") +
                 scene_view(comparison) + format_packed_element("scene-data", data.json)) +
         three_scripts() + format_script_element(assets::scene_js);
}

}  // namespace clast::report_detail
