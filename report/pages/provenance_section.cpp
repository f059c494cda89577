#include "report/pages/report_sections.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/version.hpp"
#include "mesh/reference_system.hpp"
#include "report/html/html_page.hpp"
#include "study/campaign/ground_fields.hpp"
#include "study/compare/ensemble_effects.hpp"
#include "study/results/block_scale.hpp"
#include "study/results/block_stiffness.hpp"

namespace clast::report_detail {
namespace {

/// Stiffness and time step of every block.
std::string stiffness_table(const CampaignResults& results) {
  const std::vector<BlockStiffnessRanges> blocks =
      collect_stiffness_by_block(results, results.runs);
  if (blocks.empty()) return "";
  std::vector<std::string> heads = {"block"};
  for (const StiffnessRange& value : blocks.front().values) heads.push_back(value.heading);
  HtmlTable table(heads, 1);
  const auto add = [&](const BlockStiffnessRanges& block) {
    std::vector<std::string> row = format_stiffness_cells(block);
    row.insert(row.begin(), block.block);
    table.row(row);
  };
  for (const BlockStiffnessRanges& block : blocks) add(block);
  if (blocks.size() > 1) add(combine_stiffness(blocks));
  return table.html();
}

/// True if any zone has this parameter in any draw.
bool any_states(const CampaignResults& results, const GroundParameterField& field) {
  const auto states = [&](const GroundParameters& zone) { return zone.*field.value != 0.0; };
  return std::any_of(results.ground.begin(), results.ground.end(), states) ||
         std::any_of(results.ground_sets.begin(), results.ground_sets.end(), [&](const auto& set) {
           return std::any_of(set.zones.begin(), set.zones.end(), states);
         });
}

/// The ground parameters that runs had: of every zone, and of block groups where theirs differ.
/// Where members of an ensemble differ, the range drawn.
std::string ground_table(const CampaignResults& results) {
  std::map<std::string, std::vector<const GroundParameterSet*>> sets_of;  // by block group
  for (const GroundParameterSet& set : results.ground_sets) sets_of[set.group].push_back(&set);
  const GroundParameterSet central{"", 0, results.ground};
  if (sets_of[""].empty()) sets_of[""] = {&central};
  std::vector<std::string> heads = {"ground zone"};
  std::vector<GroundParameterField> fields;
  for (const GroundParameterField& field : ground_parameter_fields()) {
    if (field.is_soil_parameter && !any_states(results, field)) continue;
    fields.push_back(field);
    heads.emplace_back(field.heading);
  }
  HtmlTable table(heads, 1);
  for (std::size_t zone = 0; zone < results.zone_names.size(); ++zone) {
    std::vector<std::string> usual;
    for (const auto& [group, sets] : sets_of) {
      std::vector<std::string> cells;
      for (const GroundParameterField& field : fields) {
        double low = INFINITY, high = -INFINITY;
        for (const GroundParameterSet* set : sets) {
          low = std::min(low, set->zones[zone].*field.value);
          high = std::max(high, set->zones[zone].*field.value);
        }
        cells.push_back(!field.required && high == 0.0
                            ? "not stated"
                            : format_significant_digits(low) +
                                  (low < high ? " to " + format_significant_digits(high) : ""));
      }
      if (group.empty()) usual = cells;
      if (!group.empty() && cells == usual) continue;
      cells.insert(cells.begin(),
                   results.zone_names[zone] + (group.empty() ? "" : ", group " + group));
      table.row(cells);
    }
  }
  const std::uint32_t members = count_ensemble_members(results);
  return table.html() +
         (members > 1 ? format_paragraph("The ranges are over the " + std::to_string(members) +
                                         " draws; each draw is in ground_sets.csv.")
                      : "");
}

std::string released(const CampaignResults& results) {
  const std::size_t points = results.release_points.size();
  if (!results.persistent_blocks) {
    const std::size_t members = count_ensemble_members(results);
    const std::size_t sets = results.blocks.size() * points * members;
    return format_count(results.blocks.size(), "block") + " \xC3\x97 " +
           format_count(points, "point") + " \xC3\x97 " +
           format_count(sets > 0 ? results.planned_runs / sets : 0, "orientation") +
           (members > 1 ? " \xC3\x97 " + format_count(members, "draw") + " of the ground" : "");
  }
  const auto removed = static_cast<std::size_t>(std::count_if(
      results.persistent_block_records.begin(), results.persistent_block_records.end(),
      [](const PersistentBlockRecord& stay) { return std::isfinite(stay.removed_at); }));
  return format_count(results.planned_runs / results.persistent_blocks->blocks_per_realisation,
                      "realisation") +
         " of " + format_count(results.persistent_blocks->blocks_per_realisation, "block") +
         (results.persistent_blocks->at_once
              ? ", released " + (points > 1
                                     ? "as " + format_count(points, "block mass", "block masses")
                                     : "at once, as one mass")
              : ", released one after another from " + format_count(points, "point")) +
         " and left at their stops" +
         (removed > 0 ? ", except for " + format_count(removed, "block that was removed",
                                                       "blocks that were removed")
                      : "");
}

/// Lists the settings common to all runs of a file.
std::string settings_of(const Comparison& comparison, const CampaignResults& results) {
  std::string html = "<dl class=\"facts\">\n";
  html += format_fact("Runs", std::to_string(results.runs.size()) + " of " +
                                  std::to_string(results.planned_runs) + " planned");
  html += format_fact("Released", released(results));
  html += format_fact("Contact law", "energy restitution, weights " + name_of(results.weighting));
  const std::vector<std::string> cells =
      format_stiffness_cells(combine_stiffness(collect_stiffness_by_block(results, results.runs)));
  html +=
      format_fact("Stiffness and time step", "k_n " + cells[0] + " N/m, step " + cells[3] + " s");
  html += format_fact(
      "Downslope (x, y)",
      format_fixed(comparison.downslope.x(), 4) + ", " + format_fixed(comparison.downslope.y(), 4) +
          (comparison.downslope_given ? " (as specified)" : " (mean release to stop)"));
  html += format_fact("Coordinates", results.frame.crs.empty()
                                         ? "map frame of the terrain, no CRS given"
                                         : reference_system_name(results.frame.crs));
  return html +
         (results.has_contacts() ? format_fact("Simulated with", "clast " + results.program_version)
                                 : format_fact("Computed by", results.engine + ", read by clast " +
                                                                  results.program_version)) +
         "</dl>\n";
}

std::string scales_of(const CampaignResults& results) {
  std::string text;
  for (const BlockSummary& block : results.blocks) {
    if (block.scale == 1.0) continue;
    if (block.library_block() != block.id) return "";  // drawn ones are too many
    text += (text.empty() ? "As requested, " : ", ") + describe_block_scale(block);
  }
  return text.empty() ? "" : format_paragraph(text + ".");
}

/// Lists the warnings that are not among the cautions.
std::string notes_of(const Comparison& comparison) {
  std::string items;
  std::size_t count = 0;
  for (const std::string& warning : comparison.warnings) {
    const bool above =
        std::any_of(comparison.cautions.begin(), comparison.cautions.end(),
                    [&](const ComparisonWarning& caution) {
                      return std::count(caution.texts.begin(), caution.texts.end(), warning) > 0;
                    });
    if (above) continue;
    items += format_paragraph(warning);
    ++count;
  }
  return items.empty() ? "" : format_folded_section(format_count(count, "more warning"), items);
}

}  // namespace

std::string format_provenance_section(const Comparison& comparison) {
  std::string html;
  for (std::size_t file = 0; file < comparison.results.size(); ++file) {
    const CampaignResults& results = comparison.results[file];
    html +=
        "<h3>" +
        escape_html("File " + std::to_string(file + 1) + ": " + results.file.filename().string()) +
        "</h3>\n";
    html += settings_of(comparison, results) + scales_of(results) + ground_table(results);
    html +=
        format_folded_section("Stiffness and time step of every block", stiffness_table(results));
    std::string inputs = "<p>Campaign SHA-256 <code>" + escape_html(results.campaign_sha256) +
                         "</code></p>\n<ul class=\"note\">\n";
    for (const std::string& input : results.inputs) {
      inputs += "<li><code>" + escape_html(input) + "</code></li>\n";
    }
    html += format_folded_section("Input files", inputs + "</ul>\n");
    html += format_folded_section("Campaign file",
                                  "<pre>" + escape_html(results.campaign_text) + "</pre>");
  }
  return format_section("What was run", html + notes_of(comparison)) + "<footer>Made by clast " +
         escape_html(version()) +
         ". All numbers are in the tables in the same folder; map layers are in "
         "stops.gpkg.</footer>\n";
}

}  // namespace clast::report_detail
