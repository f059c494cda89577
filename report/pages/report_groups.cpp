#include "report/pages/report_groups.hpp"

#include <algorithm>
#include <array>

#include "report/html/html_page.hpp"

namespace clast::report_detail {

bool has_several_files(const Comparison& comparison) { return comparison.results.size() > 1; }

std::vector<std::size_t> select_groups_of_kind(const Comparison& comparison, RunGroupKind kind) {
  std::vector<std::size_t> found;
  for (std::size_t g = 0; g < comparison.groups.size(); ++g) {
    const RunGroup& group = comparison.groups[g];
    if (group.kind == kind && group.file.has_value() == has_several_files(comparison)) {
      found.push_back(g);
    }
  }
  return found;
}

std::string short_group_name(const RunGroup& group) {
  std::string name = group.kind == RunGroupKind::kAll ? "all" : group.key;
  if (group.kind == RunGroupKind::kSneedFolk) name += " (Sneed-Folk)";
  return group.file ? "file " + std::to_string(*group.file + 1) + ": " + name : name;
}

void append_list_item(std::string& list, const std::string& item) {
  list += (list.empty() ? "" : "; ") + item;
}

std::string format_headed_list(const std::string& head, const std::string& list) {
  if (list.empty()) return "";
  return "<p><b>" + escape_html(head) + "</b> " + escape_html(list) + ".</p>\n";
}

std::string block_class_of_group(const Comparison& comparison, const RunGroup& group) {
  const std::string& first = comparison.rows[group.rows.front()].block->garcia;
  const bool same = std::all_of(group.rows.begin(), group.rows.end(), [&](std::size_t row) {
    return comparison.rows[row].block->garcia == first;
  });
  return same ? first : std::string();
}

std::pair<std::string, std::string> choose_curve_style(
    const Comparison& comparison, const RunGroup& group,
    const std::vector<std::string>& classes_before) {
  if (group.kind == RunGroupKind::kGarcia) {
    return {class_colour(group.key), kDashes[group.file.value_or(0) % kDashes.size()]};
  }
  const std::string name = block_class_of_group(comparison, group);
  const std::string colour = class_colour(name);
  const auto before =
      static_cast<std::size_t>(std::count(classes_before.begin(), classes_before.end(), name));
  const std::array<std::string, 3> shades = {colour, mix_colours(colour, "#ffffff", 0.45),
                                             mix_colours(colour, "#000000", 0.45)};
  return {shades[before / kDashes.size() % shades.size()], kDashes[before % kDashes.size()]};
}

std::string format_mean_and_deviation(const SampleSummary& summary, int decimals, double unit) {
  if (summary.count == 0) return "-";
  if (summary.count == 1)
    return format_fixed(summary.mean * unit, decimals);  // one does not scatter
  return format_fixed(summary.mean * unit, decimals) + " \xC2\xB1 " +
         format_fixed(summary.std * unit, decimals);
}

std::string format_summary_value(double value, const SampleSummary& summary, int decimals) {
  return summary.count == 0 ? "-" : format_fixed(value, decimals);
}

}  // namespace clast::report_detail
