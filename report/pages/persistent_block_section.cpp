#include <cmath>

#include "report/html/html_page.hpp"
#include "report/pages/report_groups.hpp"
#include "report/pages/report_sections.hpp"

namespace clast::report_detail {
namespace {

/// A block counts as moved on from this share of its S; less is how far its contacts yield.
constexpr double kMovedFraction = 0.1;

/// Returns the record of each row; null for single blocks and for simultaneous releases.
std::vector<const PersistentBlockRecord*> stays_of_rows(const Comparison& comparison) {
  std::vector<const PersistentBlockRecord*> stays;
  for (const RunRow& row : comparison.rows) {
    const CampaignResults& results = comparison.results[row.file];
    const bool one_by_one = results.persistent_blocks && !results.persistent_blocks->at_once;
    stays.push_back(one_by_one ? results.find_persistent_block(row.record->run) : nullptr);
  }
  return stays;
}

std::string count_and_share(std::size_t count, std::size_t all) {
  return std::to_string(count) + " (" +
         format_percent(static_cast<double>(count) / static_cast<double>(all)) + ")";
}

/// The cells of a group without its name; empty where none of its blocks stayed among others.
std::vector<std::string> cells_of(const Comparison& comparison, const RunGroup& group,
                                  const std::vector<const PersistentBlockRecord*>& stays) {
  std::size_t runs = 0, hitting = 0, removed = 0;
  bool known = true;  // whether blocks that were hit are
  double hit = 0.0;
  std::vector<double> moved;
  for (const std::size_t row : group.rows) {
    const PersistentBlockRecord* stay = stays[row];
    if (!stay) continue;
    ++runs;
    known &= comparison.results[comparison.rows[row].file].has_contacts();
    hitting += stay->blocks_hit > 0;
    hit += stay->blocks_hit;
    removed += std::isfinite(stay->removed_at);
    if (stay->later_displacement > kMovedFraction * comparison.rows[row].block->axes.S) {
      moved.push_back(stay->later_displacement);
    }
  }
  if (runs == 0) return {};
  const SampleSummary summary = summarise_sample(moved);
  return {std::to_string(runs),
          known ? count_and_share(hitting, runs) : "not known",
          known ? format_fixed(hit / static_cast<double>(runs), 2) : "not known",
          count_and_share(moved.size(), runs),
          format_summary_value(summary.median, summary, 2),
          format_summary_value(summary.max, summary, 2),
          count_and_share(removed, runs)};
}

}  // namespace

std::string format_persistent_blocks_section(const Comparison& comparison) {
  const std::vector<const PersistentBlockRecord*> stays = stays_of_rows(comparison);
  HtmlTable table({"class", "runs", "hit others", "others hit, mean", "displaced later",
                   "displacement, median, m", "displacement, max, m", "removed"},
                  1);
  bool any = false;
  for (const RunGroupKind kind :
       {RunGroupKind::kGarcia, RunGroupKind::kSneedFolk, RunGroupKind::kAll}) {
    for (const std::size_t g : select_groups_of_kind(comparison, kind)) {
      std::vector<std::string> cells = cells_of(comparison, comparison.groups[g], stays);
      if (cells.empty()) continue;
      any = true;
      cells.insert(cells.begin(), short_group_name(comparison.groups[g]));
      table.row(std::move(cells));
    }
  }
  if (!any) return "";
  return format_section(
      "Contacts with persistent blocks",
      format_paragraph("The table gives how many other blocks a block hit, and how far later "
                       "blocks displaced it; displacements below a tenth of its S are not counted. "
                       "Stops are the positions at the end of the realisation.") +
          table.html());
}

}  // namespace clast::report_detail
