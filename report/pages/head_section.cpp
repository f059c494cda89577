#include "report/pages/report_sections.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "core/version.hpp"
#include "report/html/html_page.hpp"
#include "report/pages/report_groups.hpp"
#include "study/block_stiffness.hpp"
#include "study/ensemble_effects.hpp"

namespace clast::report_detail {
namespace {

/// The same text for all files, or each file's own.
template <class Text>
std::string per_file(const Comparison& comparison, Text text_of) {
  std::string joined;
  std::set<std::string> seen;
  for (const CampaignResults& results : comparison.results) {
    const std::string text = text_of(results);
    if (seen.insert(text).second) joined += (joined.empty() ? "" : "; ") + text;
  }
  return joined;
}

std::string warning_box(const Comparison& comparison) {
  if (comparison.warnings.empty()) {
    return "<div class=\"fine\">No warnings: every planned run is stored and came to rest on the "
           "terrain with its energy accounted for.</div>\n";
  }
  return note_box("Read this first", comparison.warnings);
}

}  // namespace

std::string head_section(const Comparison& comparison) {
  std::size_t blocks = 0, classes = 0;
  for (const Group& group : comparison.groups) {
    if (group.file) continue;
    blocks += group.kind == GroupKind::kBlock;
    classes += group.kind == GroupKind::kGarcia;
  }
  const auto many = [](std::size_t count, const std::string& one, const std::string& more) {
    return std::to_string(count) + " " + (count == 1 ? one : more);
  };
  std::string lead = many(comparison.rows.size(), "run", "runs") + " of " +
                     many(blocks, "block", "blocks") + " in " +
                     many(classes, "shape class", "shape classes");
  std::string html = "<h1>Rockfall runs compared by shape</h1>\n<p class=\"lead\">" +
                     escaped(lead) +
                     (several_files(comparison)
                          ? ", from " + std::to_string(comparison.results.size()) + " campaigns"
                          : std::string()) +
                     "</p>\n";
  html += warning_box(comparison);
  html += "<dl class=\"facts\">\n";
  html += fact("Results", per_file(comparison, [](const CampaignResults& results) {
                 return results.file.filename().string();
               }));
  html += fact(
      "Released", per_file(comparison, [&](const CampaignResults& results) {
        const std::size_t points = results.release_points.size();
        if (results.stay) {
          const auto removed =
              std::count_if(results.stays.begin(), results.stays.end(),
                            [](const StayRecord& stay) { return std::isfinite(stay.removed_at); });
          return many(results.planned_runs / results.stay->blocks_each, "realisation",
                      "realisations") +
                 " of " + many(results.stay->blocks_each, "block", "blocks") +
                 (results.stay->at_once
                      ? ", released at once as one mass"
                      : ", released one after the other from " + many(points, "point", "points")) +
                 " and left where they stop" +
                 (removed > 0
                      ? ", but for " + many(static_cast<std::size_t>(removed),
                                            "block that was removed", "blocks that were removed")
                      : "");
        }
        const std::size_t members = ensemble_members(results);
        const std::size_t sets = results.blocks.size() * points * members;
        return many(results.blocks.size(), "block", "blocks") + " \xC3\x97 " +
               many(points, "point", "points") + " \xC3\x97 " +
               many(sets > 0 ? results.planned_runs / sets : 0, "orientation", "orientations") +
               (members > 1 ? " \xC3\x97 " + many(members, "draw", "draws") + " of the ground"
                            : "");
      }));
  html += fact("Contact law", "energy restitution, weights " +
                                  per_file(comparison, [](const CampaignResults& results) {
                                    return name_of(results.weights);
                                  }));
  html += fact("Stiffness and time step", per_file(comparison, [](const CampaignResults& results) {
                 const BlockStiffness all = over_all(stiffness_by_block(results, results.runs));
                 return "k_n " + stiffness_cells(all)[0] + " N/m, step " + stiffness_cells(all)[3] +
                        " s; listed by block at the end of this page";
               }));
  html += fact("Downslope (x, y)",
               fixed(comparison.downslope.x(), 4) + ", " + fixed(comparison.downslope.y(), 4) +
                   (comparison.downslope_asked ? " (as asked)" : " (mean release to stop)"));
  html += fact("Coordinates", comparison.results.front().frame.crs.empty()
                                  ? "map frame of the terrain, no CRS given"
                                  : comparison.results.front().frame.crs);
  html +=
      fact("Simulated with", "clast " + per_file(comparison, [](const CampaignResults& results) {
                               return results.program_version;
                             }));
  html += fact("Report by", std::string("clast ") + version());
  return html + "</dl>\n";
}

}  // namespace clast::report_detail
