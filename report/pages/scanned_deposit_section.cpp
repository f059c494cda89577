#include "report/pages/scanned_deposit_section.hpp"

#include "report/html/html_page.hpp"
#include "report/text/scanned_deposit_text.hpp"

namespace clast::report_detail {
namespace {

/// "0.354 (0.331 to 0.380)"
std::string size_cell(const EstimatedValue& estimate) {
  return format_significant_digits(estimate.value, 3) + " (" +
         format_significant_digits(estimate.interval.low, 3) + " to " +
         format_significant_digits(estimate.interval.high, 3) + ")";
}

std::string share_cell(const EstimatedValue& estimate) {
  return format_percent(estimate.value) + " (" + format_percent(estimate.interval.low) + " to " +
         format_percent(estimate.interval.high) + ")";
}

std::string size_tables(const ScannedDepositSummary& deposit) {
  std::string html;
  for (std::size_t q = 0; q < kWeightedQuantities.size(); ++q) {
    const bool volume = q + 1 == kWeightedQuantities.size();
    std::vector<std::string> heads = {std::string(kWeightedQuantities[q]) +
                                      (volume ? ", m\xC2\xB3" : ", m")};
    heads.insert(heads.end(), kWeightedPercentileNames.begin(), kWeightedPercentileNames.end());
    HtmlTable table(heads, 1);
    for (const WeightedSizes& sizes : deposit.sizes) {
      std::vector<std::string> cells = {heading_of(sizes.weighting)};
      for (const EstimatedValue& estimate : sizes.percentiles[q]) {
        cells.push_back(size_cell(estimate));
      }
      table.row(std::move(cells));
    }
    html += table.html();
  }
  return html;
}

std::string class_tables(const ScannedDepositSummary& deposit) {
  std::string html;
  for (const CorrectedSchemeFractions& scheme : deposit.schemes) {
    HtmlTable table({scheme.scheme, "blocks that show", "all blocks of the deposit"}, 1);
    for (const CorrectedFraction& one : scheme.fractions) {
      table.row({one.name, share_cell(one.found), share_cell(one.corrected)});
    }
    html += table.html();
  }
  return html;
}

}  // namespace

std::string format_scanned_deposit_section(const PopulationReport& report,
                                           const PopulationDiagrams& diagrams) {
  std::string html;
  for (std::size_t i = 0; i < report.populations.size(); ++i) {
    const ReportedPopulation& reported = report.populations[i];
    if (!reported.deposit) continue;
    const ScannedDepositSummary& deposit = *reported.deposit;
    const std::string suffix = population_file_suffix(report, i);
    html += "<h3>" + escape_html(reported.population.name) + "</h3>\n";
    html += format_paragraph(
        format_count(deposit.blocks, "block") + " found; with those that do not show, about " +
        format_significant_digits(deposit.corrected_blocks.value, 3) + " (" +
        format_significant_digits(deposit.corrected_blocks.interval.low, 3) + " to " +
        format_significant_digits(deposit.corrected_blocks.interval.high, 3) + "). " +
        describe_visibility_correction(deposit.correction));
    html += "<div class=\"charts\">" + format_figure(diagrams.at("found_sizes" + suffix)) +
            format_figure(diagrams.at("long_axes" + suffix)) + "</div>\n";
    html += format_paragraph(describe_long_axes(deposit.long_axes)) + size_tables(deposit) +
            class_tables(deposit);
  }
  if (html.empty()) return {};
  return format_section(
      "What the surface shows and hides",
      format_paragraph(
          "Sizes by number are those of the blocks that show. By area, each block counts with its "
          "area in plan, and by grid with the part of it that is seen from above, as if the points "
          "of a grid were counted (Wolman). Corrected sizes and fractions are those of all blocks "
          "of the deposit by number: each block stands for as many as are needed to find one of "
          "its size. In fractions, each block counts in all classes that its axes may have, and "
          "the "
          "blur by the errors of the axes is removed. "
          "Intervals of 95 % include the sizes and confidences of the blocks, and which blocks of "
          "this deposit show; those of other parts of it may differ more.") +
          html);
}

}  // namespace clast::report_detail
