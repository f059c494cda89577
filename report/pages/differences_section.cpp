#include <algorithm>
#include <cmath>
#include <map>

#include "core/number_text.hpp"
#include "report/charts/plotly_chart.hpp"
#include "report/html/html_page.hpp"
#include "report/pages/report_groups.hpp"
#include "report/pages/report_sections.hpp"
#include "report/text/contrast_text.hpp"

namespace clast::report_detail {
namespace {

/// Kinds of groups that are too many to be compared pair by pair.
std::string too_many_groups(const Comparison& comparison) {
  std::map<std::string, std::size_t> count;
  for (const RunGroup& group : comparison.groups) {
    if (group.file || group.kind == RunGroupKind::kAll) continue;
    ++count[group.kind == RunGroupKind::kBlock    ? "blocks"
            : group.kind == RunGroupKind::kColumn ? "values of " + group.column
                                                  : "classes"];
  }
  std::string html;
  for (const auto& [kind, number_of] : count) {
    if (number_of <= kMaxComparedGroups) continue;
    html +=
        format_paragraph(std::to_string(number_of) + " " + kind + " are too many: at most " +
                         std::to_string(kMaxComparedGroups) +
                         " are compared pair by pair. Compare a selection, or group by a column.");
  }
  return html;
}

/// One picture: the pairs of one kind, each quantity a row.
struct Picture {
  std::string title;  ///< "compact against elongated"
  std::vector<const GroupDifference*> rows;
};

/// Classes in all quantities, values of columns in runout.
std::vector<Picture> pictures_of(const Comparison& comparison) {
  std::vector<Picture> pictures;
  for (const GroupDifference& one : comparison.differences) {
    const RunGroup& first = comparison.groups[one.first];
    const RunGroup& second = comparison.groups[one.second];
    const bool classes = first.kind == RunGroupKind::kGarcia;
    if (!classes && !(first.kind == RunGroupKind::kColumn && one.quantity == "runout_m")) continue;
    const std::string title =
        classes ? first.key + " against " + second.key : "runout by " + first.column;
    if (pictures.empty() || pictures.back().title != title) pictures.push_back({title, {}});
    pictures.back().rows.push_back(&one);
  }
  return pictures;
}

std::string row_name(const Comparison& comparison, const GroupDifference& one) {
  const RunGroup &first = comparison.groups[one.first], &second = comparison.groups[one.second];
  return first.kind == RunGroupKind::kGarcia ? quantity_label(one.quantity).name
                                             : first.key + " against " + second.key;
}

std::string difference_chart(const Comparison& comparison, const Picture& picture) {
  std::vector<IntervalRow> marks;
  for (const GroupDifference* one : picture.rows) {
    // An angle to either side has no size to be a share of.
    const double size = 0.5 * (std::abs(one->first_mean) + std::abs(one->second_mean));
    if (one->quantity == "lateral_deg" || !one->interval || !(size > 0.0)) continue;
    const double unit = 100.0 / size;
    marks.push_back({row_name(comparison, *one), unit * one->estimate, unit * one->interval->low,
                     unit * one->interval->high, one->verdict() == ContrastVerdict::kSignificant,
                     describe_effect(*one, comparison)});
  }
  return draw_interval_chart(picture.title, "difference, % of the mean, with 95 % interval", marks);
}

/// "More than chance: runout 13 m more (10 to 17 m), ..."
std::string words_for(const Comparison& comparison, const Picture& picture) {
  std::map<ContrastVerdict, std::string> lists;
  std::size_t tests = 0;
  for (const GroupDifference* one : picture.rows) {
    const ContrastVerdict verdict = one->verdict();
    const bool with_gap =
        verdict == ContrastVerdict::kSignificant || verdict == ContrastVerdict::kUntested;
    append_list_item(
        lists[verdict],
        row_name(comparison, *one) + (with_gap ? " " + describe_difference(*one) : std::string()));
    tests = std::max(tests, one->family_size);
  }
  return format_headed_list(picture.title + ", significant differences:",
                            lists[ContrastVerdict::kSignificant]) +
         format_headed_list("Means do not differ significantly, but distributions do:",
                            lists[ContrastVerdict::kDistributionDiffers]) +
         format_headed_list("Not significant after the correction, because one of " +
                                std::to_string(tests) +
                                " differences tested can be this large by chance:",
                            lists[ContrastVerdict::kInsignificantAfterCorrection]) +
         format_headed_list("No significant difference:", lists[ContrastVerdict::kInsignificant]) +
         format_headed_list(picture.title + ", from one realisation, without a test:",
                            lists[ContrastVerdict::kUntested]);
}

std::string make_table(const Comparison& comparison) {
  HtmlTable table(
      {"first", "second", "quantity", "first mean", "second mean", "difference", "95 % from",
       "95 % to", "Cliff's delta", "Hedges' g", "KS distance", "p (Holm)", "significant"},
      3);
  for (const GroupDifference& one : comparison.differences) {
    const RunGroup& first = comparison.groups[one.first];
    // Pairs of blocks are many; the table differences.csv has them.
    if (first.kind != RunGroupKind::kGarcia && first.kind != RunGroupKind::kColumn) continue;
    table.row({first.name, comparison.groups[one.second].name, one.quantity,
               format_significant(one.first_mean, 3), format_significant(one.second_mean, 3),
               format_significant(one.estimate, 3),
               one.interval ? format_significant(one.interval->low, 3) : "-",
               one.interval ? format_significant(one.interval->high, 3) : "-",
               format_significant(one.cliffs_delta, 3),
               one.hedges_g ? format_significant(*one.hedges_g, 3) : "-",
               format_significant(one.ks_distance, 3),
               one.holm_p_value ? format_significant(*one.holm_p_value, 2) : "-",
               !one.holm_p_value      ? "-"
               : one.is_significant() ? "yes"
                                      : "no"});
  }
  return table.html();
}

/// Describes the methods of intervals and tests.
std::string method_of(const Comparison& comparison) {
  const bool stay =
      std::any_of(comparison.results.begin(), comparison.results.end(),
                  [](const CampaignResults& results) { return results.persistent_blocks; });
  const bool tested =
      std::any_of(comparison.differences.begin(), comparison.differences.end(),
                  [](const GroupDifference& one) { return one.holm_p_value.has_value(); });
  if (!tested) {
    return format_paragraph(
        "With one realisation, significance cannot be tested, so there are no intervals and no "
        "tests. Pairs of blocks are in differences.csv.");
  }
  const bool one_point = !stay && std::all_of(comparison.results.begin(), comparison.results.end(),
                                              [](const CampaignResults& results) {
                                                return results.release_points.size() == 1;
                                              });
  const std::string drawn =
      one_point ? "The intervals are from bootstrap resampling of runs; because there is only one "
                  "release point, they do not cover other release points. "
                : "The intervals are from bootstrap resampling of whole " +
                      std::string(stay ? "realisations" : "release points") +
                      ", because runs of the same one depend on each other. ";
  return format_paragraph(
      drawn +
      "A difference is significant if random permutations of the runs give an equal or larger KS "
      "distance in less than 5 % of the cases, after Holm's correction for all tests of the same "
      "kind. Pairs of blocks are in differences.csv.");
}

}  // namespace

std::string format_differences_section(const Comparison& comparison) {
  const std::vector<Picture> pictures = pictures_of(comparison);
  std::string html = too_many_groups(comparison);
  for (const Picture& picture : pictures) {
    html += words_for(comparison, picture) + difference_chart(comparison, picture);
  }
  if (!pictures.empty()) {
    html += format_folded_section("Tests and corrections",
                                  method_of(comparison) + make_table(comparison));
  }
  return html.empty() ? html : format_section("Differences", html);
}

}  // namespace clast::report_detail
