#include <algorithm>
#include <map>

#include "report/html/html_page.hpp"
#include "report/pages/report_groups.hpp"
#include "report/pages/report_sections.hpp"
#include "report/text/capital.hpp"
#include "report/text/contrast_text.hpp"
#include "report/text/subject_words.hpp"

namespace clast::report_detail {
namespace {

/// Pairs of files that are put in words; of more, each file against the first is.
constexpr std::size_t kMostPairs = 6;

std::string with_unit(const DepositQuantity& figure) {
  return figure.phrase + (figure.unit.empty() ? "" : ", " + figure.unit);
}

std::string interval_text(const std::optional<Interval>& interval, int decimals) {
  return interval ? format_fixed(interval->low, decimals) + " to " +
                        format_fixed(interval->high, decimals)
                  : "-";
}

/// Mean, interval, least and most of every figure, for each file.
std::string figures_table(const Comparison& comparison, const DepositQuantityComparison& figures) {
  std::vector<std::uint32_t> files;
  for (const DepositQuantitySummary& one : figures.files) {
    if (files.empty() || files.back() != one.file) files.push_back(one.file);
  }
  std::vector<std::string> heads = {"quantity"};
  for (const std::uint32_t file : files) {
    const std::string of_file =
        has_several_files(comparison) ? "file " + std::to_string(file + 1) + ": " : "";
    for (const char* head : {"mean and std", "95 % interval of the mean", "least", "most"}) {
      heads.push_back(of_file + head);
    }
  }
  HtmlTable table(heads, 1);
  for (std::size_t i = 0; i < deposit_quantities().size(); ++i) {
    const DepositQuantity& figure = deposit_quantities()[i];
    std::vector<std::string> cells = {with_unit(figure)};
    for (const std::uint32_t file : files) {
      DepositQuantitySummary found;
      for (const DepositQuantitySummary& one : figures.files) {
        if (one.file == file && one.quantity == i) found = one;
      }
      cells.push_back(format_mean_and_deviation(found.summary, figure.decimals));
      cells.push_back(interval_text(found.interval, figure.decimals));
      cells.push_back(format_summary_value(found.minimum, found.summary, figure.decimals));
      cells.push_back(format_summary_value(found.summary.max, found.summary, figure.decimals));
    }
    table.row(std::move(cells));
  }
  return table.html();
}

/// Describes in which quantities a pair of files differs, by how much, and in which not.
std::string describe_pair(const Comparison& comparison,
                          const std::vector<const DepositQuantityDifference*>& pair) {
  std::map<ContrastVerdict, std::string> lists;
  std::size_t fewest = pair.front()->first.summary.count, tests = 0;
  for (const DepositQuantityDifference* one : pair) {
    const std::string& words = deposit_quantities()[one->first.quantity].phrase;
    fewest = std::min({fewest, one->first.summary.count, one->second.summary.count});
    tests = std::max(tests, one->family_size);
    const ContrastVerdict verdict = one->verdict();
    const bool with_gap = verdict == ContrastVerdict::kSignificant ||
                          verdict == ContrastVerdict::kInsignificantAfterCorrection;
    append_list_item(lists[verdict],
                     words + (with_gap ? " " + describe_difference(*one) : std::string()));
  }
  const std::string names = capitalized(results_file_label(comparison, pair.front()->first.file)) +
                            " against " + results_file_label(comparison, pair.front()->second.file);
  if (tests == 0) {
    return format_paragraph(names + ": no interval of the difference can be given, " +
                            (fewest < 2 ? "because it requires two realisations of each file."
                                        : "because the realisations do not differ."));
  }
  const std::string& clear = lists[ContrastVerdict::kSignificant];
  return (clear.empty() ? format_paragraph(names + ": no quantity differs significantly.")
                        : format_headed_list(names + ", significant differences:", clear)) +
         format_headed_list("Not significant after the correction, because one of " +
                                std::to_string(tests) +
                                " differences tested can be this large by chance:",
                            lists[ContrastVerdict::kInsignificantAfterCorrection]) +
         format_headed_list(
             "Not significant, because the 95 % interval of the difference contains zero:",
             lists[ContrastVerdict::kInsignificant]) +
         format_headed_list("Without an interval, because the realisations do not differ:",
                            lists[ContrastVerdict::kUntested]);
}

std::string differences_table(const Comparison& comparison,
                              const DepositQuantityComparison& figures) {
  HtmlTable table({"quantity", "first", "second", "realisations", "first mean", "second mean",
                   "difference", "95 % interval", "p", "p (Holm)", "significant"},
                  3);
  for (const DepositQuantityDifference& one : figures.differences) {
    const DepositQuantity& figure = deposit_quantities()[one.first.quantity];
    table.row({with_unit(figure), results_file_label(comparison, one.first.file),
               results_file_label(comparison, one.second.file),
               std::to_string(one.first.summary.count) + " and " +
                   std::to_string(one.second.summary.count),
               format_fixed(one.first.summary.mean, figure.decimals),
               format_fixed(one.second.summary.mean, figure.decimals),
               format_fixed(one.estimate, figure.decimals),
               interval_text(one.interval, figure.decimals),
               one.p_value ? format_significant(*one.p_value, 2) : "-",
               one.holm_p_value ? format_significant(*one.holm_p_value, 2) : "-",
               !one.holm_p_value                                ? "-"
               : one.verdict() == ContrastVerdict::kSignificant ? "yes"
                                                                : "no"});
  }
  return table.html();
}

/// The files against each other; empty where one file has realisations.
std::string differences_of_files(const Comparison& comparison,
                                 const DepositQuantityComparison& figures) {
  if (figures.differences.empty()) {
    std::size_t files = 0;
    for (const DepositQuantitySummary& one : figures.files) files += one.quantity == 0;
    return files < 2 ? ""
                     : format_paragraph(std::to_string(files) + " files are too many: at most " +
                                        std::to_string(kMaxComparedGroups) +
                                        " are compared pair by pair. Compare a selection.");
  }
  std::vector<std::vector<const DepositQuantityDifference*>> pairs;
  for (const DepositQuantityDifference& one : figures.differences) {
    const auto same = [&](const DepositQuantityDifference* other) {
      return other->first.file == one.first.file && other->second.file == one.second.file;
    };
    if (pairs.empty() || !same(pairs.back().front())) pairs.emplace_back();
    pairs.back().push_back(&one);
  }
  std::string html;
  for (const std::vector<const DepositQuantityDifference*>& pair : pairs) {
    const bool with_first = pair.front()->first.file == figures.differences.front().first.file;
    if (pairs.size() <= kMostPairs || with_first) html += describe_pair(comparison, pair);
  }
  return html +
         format_folded_section(
             "Differences between the files",
             format_paragraph(
                 "The realisations are independent of each other. The intervals are those of "
                 "Welch's test, for groups with different variances. A difference is significant "
                 "if p is below 0.05 after Holm's correction for all differences in the table. The "
                 "table is also in realisation_differences.csv.") +
                 differences_table(comparison, figures));
}

/// The blocks together against the same alone; empty where no single runs are compared.
std::string mobility_of(const Comparison& comparison, const std::vector<DepositMobility>& all) {
  if (all.empty()) return "";
  std::string html;
  HtmlTable table(
      {"group", "together", "alone", "realisations", "runs alone", "runout together, m",
       "runout alone, m", "difference, m", "95 % interval", "p", "toe together, m", "toe alone, m"},
      3);
  for (const DepositMobility& one : all) {
    if (one.group == "all") {
      html += format_paragraph(
          "Runout of " + results_file_label(comparison, one.file) + " against single blocks of " +
          results_file_label(comparison, one.single_block_file) + ", " + describe_effect(one) +
          ". The farthest block of a realisation stops after " +
          format_fixed(one.together_toe.mean, 1) +
          " m on average; the farthest of the same number of single runs would stop after " +
          format_fixed(one.alone_toe, 1) + " m.");
    }
    table.row({one.group, results_file_label(comparison, one.file),
               results_file_label(comparison, one.single_block_file),
               std::to_string(one.together_runout.count), std::to_string(one.runs),
               format_fixed(one.together_runout.mean, 2), format_fixed(one.alone_runout.mean, 2),
               format_fixed(one.difference.estimate, 2), interval_text(one.difference.interval, 2),
               one.difference.p_value ? format_significant(*one.difference.p_value, 2) : "-",
               format_fixed(one.together_toe.mean, 2), format_fixed(one.alone_toe, 2)});
  }
  return html + format_folded_section(
                    "Together and alone",
                    format_paragraph("Runouts of blocks that came to rest. Toe together is the "
                                     "largest runout of a realisation; toe alone is the expected "
                                     "largest runout of the same number of single runs.") +
                        table.html());
}

}  // namespace

std::string format_deposit_section(const ComparisonAnalyses& analyses) {
  if (analyses.deposit_results().realisations.empty()) return "";
  const Comparison& comparison = analyses.comparison();
  const DepositQuantityComparison& figures = analyses.deposit_comparison();
  return format_section(
      "The deposit",
      format_paragraph("Thickness of the deposit, averaged over the realisations" +
                       std::string(has_several_files(comparison) ? " of all files" : "") + ", m.") +
          format_deposit_map(comparison, analyses.deposit_results().rasters) +
          differences_of_files(comparison, figures) +
          mobility_of(comparison, analyses.deposit_mobility()) +
          format_folded_section(
              "Statistics of the deposit",
              format_paragraph(
                  "The statistics are for blocks that came to rest and were not removed. The crest "
                  "is the highest release point and the toe is the stop farthest from it; H / L "
                  "between them is the tangent of the travel angle. The bulk volume includes the "
                  "gaps between blocks. Each realisation is a row of realisations.csv.") +
                  figures_table(comparison, figures)));
}

}  // namespace clast::report_detail
