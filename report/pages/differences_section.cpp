#include <map>

#include <algorithm>

#include "core/number_text.hpp"
#include "report/html/html_page.hpp"
#include "report/pages/report_sections.hpp"

namespace clast::report_detail {
namespace {

std::string measured_table(const Comparison& comparison) {
  HtmlTable table(
      {"group", "measured", "simulated", "measured runout mean, m", "simulated runout mean, m",
       "measured median, m", "simulated median, m", "difference of medians, m", "95 % from",
       "95 % to", "Cliff's delta", "KS distance", "p (Holm)"},
      1);
  for (const MeasuredGroup& group : comparison.measured->groups) {
    table.row({comparison.groups[group.group].name, std::to_string(group.measured),
               std::to_string(group.simulated), fixed(group.runout.mean, 1),
               fixed(group.simulated_runout, 1), fixed(group.quartiles.median, 1),
               fixed(group.simulated_quartiles.median, 1),
               fixed(group.quartiles.median - group.simulated_quartiles.median, 1),
               fixed(group.median_difference.low, 1), fixed(group.median_difference.high, 1),
               with_digits(group.cliffs_delta, 3), with_digits(group.ks_distance, 3),
               with_digits(group.p_holm, 2)});
  }
  return "<h3>Against stops measured in the field</h3>\n" + table.html();
}

/// Kinds of groups that are too many to be compared pair by pair.
std::string too_many_groups(const Comparison& comparison) {
  std::map<std::string, std::size_t> count;
  for (const Group& group : comparison.groups) {
    if (group.file || group.kind == GroupKind::kAll) continue;
    ++count[group.kind == GroupKind::kBlock    ? "blocks"
            : group.kind == GroupKind::kColumn ? "values of " + group.column
                                               : "classes"];
  }
  std::string html;
  for (const auto& [kind, number_of] : count) {
    if (number_of <= kMostGroups) continue;
    html += paragraph(std::to_string(number_of) + " " + kind + " are more than the " +
                      std::to_string(kMostGroups) +
                      " that are compared pair by pair: so many tests would find nothing after "
                      "their correction. Compare a selection, or group by a column.");
  }
  return html;
}

}  // namespace

std::string differences_section(const Comparison& comparison) {
  HtmlTable table(
      {"first", "second", "quantity", "first mean", "second mean", "difference", "95 % from",
       "95 % to", "Cliff's delta", "Hedges' g", "KS distance", "p (Holm)", "found"},
      3);
  std::string sentences;
  for (const Difference& one : comparison.differences) {
    const Group& first = comparison.groups[one.first];
    // Pairs of blocks are many; the table differences.csv has them.
    if (first.kind != GroupKind::kGarcia && first.kind != GroupKind::kColumn) continue;
    table.row({first.name, comparison.groups[one.second].name, one.quantity,
               with_digits(one.first_mean, 3), with_digits(one.second_mean, 3),
               with_digits(one.first_mean - one.second_mean, 3),
               one.interval ? with_digits(one.interval->low, 3) : "-",
               one.interval ? with_digits(one.interval->high, 3) : "-",
               with_digits(one.cliffs_delta, 3), one.hedges_g ? with_digits(*one.hedges_g, 3) : "-",
               with_digits(one.ks_distance, 3), with_digits(one.p_holm, 2),
               one.found() ? "yes" : "no"});
    if (first.kind == GroupKind::kGarcia) sentences += paragraph(in_words(one, comparison));
  }
  std::string html;
  const bool stay = std::any_of(comparison.results.begin(), comparison.results.end(),
                                [](const CampaignResults& results) { return results.stay; });
  if (!sentences.empty()) {
    if (stay) {
      html += paragraph(
          "Blocks that stay in each other's way depend on each other: in what follows a "
          "realisation "
          "counts as one release point.");
    }
    html += paragraph(
        "Intervals are from drawing whole release points, effect sizes from all pairs of runs, and "
        "p from Kolmogorov's and Smirnov's distance after Holm's correction for all tests of the "
        "same kind of group: the share of random permutations that give as large a distance, in "
        "which the "
        "runs of a point that both groups have are exchanged, and the points that only one has go "
        "to one of the groups as a whole. All pairs, also of blocks, are in differences.csv.");
    html += too_many_groups(comparison);
    html += table.html() + sentences;
  }
  if (comparison.measured) html += measured_table(comparison);
  return html.empty() ? html : section("Differences", html);
}

}  // namespace clast::report_detail
