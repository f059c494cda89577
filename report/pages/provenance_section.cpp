#include "report/pages/report_sections.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/version.hpp"
#include "report/html/html_page.hpp"
#include "study/block_stiffness.hpp"
#include "study/ensemble_effects.hpp"
#include "study/ground_fields.hpp"

namespace clast::report_detail {
namespace {

/// More blocks than this are shown when asked for.
constexpr std::size_t kMostOpen = 20;

/// Stiffness and time step of every block.
std::string stiffness_table(const CampaignResults& results) {
  const std::vector<BlockStiffness> blocks = stiffness_by_block(results, results.runs);
  if (blocks.empty()) return "";
  std::vector<std::string> heads = {"block"};
  for (const StiffnessValue& value : blocks.front().values) heads.push_back(value.heading);
  HtmlTable table(heads, 1);
  const auto add = [&](const BlockStiffness& block) {
    std::vector<std::string> row = stiffness_cells(block);
    row.insert(row.begin(), block.block);
    table.row(row);
  };
  for (const BlockStiffness& block : blocks) add(block);
  if (blocks.size() <= kMostOpen) return table.html();
  add(over_all(blocks));
  return "<details><summary>Stiffness and time step of " + std::to_string(blocks.size()) +
         " blocks</summary>" + table.html() + "</details>\n";
}

/// The ground parameters that runs had: of every zone, and of block groups where theirs differ.
/// Where members of an ensemble differ, the range drawn.
std::string ground_table(const CampaignResults& results) {
  std::map<std::string, std::vector<const GroundSet*>> sets_of;  // by block group
  for (const GroundSet& set : results.ground_sets) sets_of[set.group].push_back(&set);
  const GroundSet central{"", 0, results.ground};
  if (sets_of[""].empty()) sets_of[""] = {&central};
  std::vector<std::string> heads = {"ground zone"};
  for (const GroundField& field : ground_fields()) heads.emplace_back(field.heading);
  HtmlTable table(heads, 1);
  for (std::size_t zone = 0; zone < results.zone_names.size(); ++zone) {
    std::vector<std::string> usual;
    for (const auto& [group, sets] : sets_of) {
      std::vector<std::string> cells;
      for (const GroundField& field : ground_fields()) {
        double low = INFINITY, high = -INFINITY;
        for (const GroundSet* set : sets) {
          low = std::min(low, set->zones[zone].*field.value);
          high = std::max(high, set->zones[zone].*field.value);
        }
        cells.push_back(!field.required && high == 0.0
                            ? "not stated"
                            : significant(low) + (low < high ? " to " + significant(high) : ""));
      }
      if (group.empty()) usual = cells;
      if (!group.empty() && cells == usual) continue;
      cells.insert(cells.begin(),
                   results.zone_names[zone] + (group.empty() ? "" : ", group " + group));
      table.row(cells);
    }
  }
  const std::uint32_t members = ensemble_members(results);
  return table.html() + (members > 1 ? paragraph("Ranges are of the " + std::to_string(members) +
                                                 " draws; each draw is in ground_sets.csv.")
                                     : "");
}

}  // namespace

std::string provenance_section(const Comparison& comparison) {
  std::string html;
  for (std::size_t file = 0; file < comparison.results.size(); ++file) {
    const CampaignResults& results = comparison.results[file];
    html += "<h3>" +
            escaped("File " + std::to_string(file + 1) + ": " + results.file.filename().string()) +
            "</h3>\n";
    html += paragraph(std::to_string(results.runs.size()) + " of " +
                      std::to_string(results.planned_runs) + " planned runs, clast " +
                      results.program_version + ".");
    html += stiffness_table(results);
    html += ground_table(results);
    html += "<p>Campaign SHA-256 <code>" + escaped(results.campaign_sha256) +
            "</code></p>\n<ul class=\"note\">\n";
    for (const std::string& input : results.inputs) {
      html += "<li><code>" + escaped(input) + "</code></li>\n";
    }
    html += "</ul>\n<details><summary>Campaign file</summary><pre>" +
            escaped(results.campaign_text) + "</pre></details>\n";
  }
  return section("What was run", html) + "<footer>Made by clast " + escaped(version()) +
         ". Every figure here is in runs.csv, barriers.csv, crossings.csv and deposits.csv beside "
         "this page; map layers are in stops.gpkg.</footer>\n";
}

}  // namespace clast::report_detail
