#include "report/pages/report_groups.hpp"

#include "report/html/html_page.hpp"

namespace clast::report_detail {

bool several_files(const Comparison& comparison) { return comparison.results.size() > 1; }

std::vector<std::size_t> groups_of(const Comparison& comparison, GroupKind kind) {
  std::vector<std::size_t> found;
  for (std::size_t g = 0; g < comparison.groups.size(); ++g) {
    const Group& group = comparison.groups[g];
    if (group.kind == kind && group.file.has_value() == several_files(comparison)) {
      found.push_back(g);
    }
  }
  return found;
}

std::string short_name(const Group& group) {
  std::string name = group.kind == GroupKind::kAll ? "all" : group.key;
  if (group.kind == GroupKind::kSneedFolk) name += " (Sneed-Folk)";
  return group.file ? "file " + std::to_string(*group.file + 1) + ": " + name : name;
}

std::string mean_and_std(const Summary& summary, int decimals, double unit) {
  if (summary.count == 0) return "-";
  return fixed(summary.mean * unit, decimals) + " \xC2\xB1 " + fixed(summary.std * unit, decimals);
}

std::string measured(double value, const Summary& summary, int decimals) {
  return summary.count == 0 ? "-" : fixed(value, decimals);
}

}  // namespace clast::report_detail
