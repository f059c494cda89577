#include "report/text/scanned_deposit_text.hpp"

#include <cmath>

#include "core/angle.hpp"
#include "core/number_text.hpp"
#include "core/text_table.hpp"

namespace clast {
namespace {

/// "0.354 (0.331 to 0.38)"
std::string estimate_text(const EstimatedValue& estimate) {
  return format_rounded(estimate.value, 3) + " (" + format_rounded(estimate.interval.low, 3) +
         " to " + format_rounded(estimate.interval.high, 3) + ")";
}

std::string percent_text(const EstimatedValue& estimate) {
  return format_decimals(100.0 * estimate.value, 1) + " (" +
         format_decimals(100.0 * estimate.interval.low, 1) + " to " +
         format_decimals(100.0 * estimate.interval.high, 1) + ")";
}

std::string sizes_text(const ScannedDepositSummary& summary) {
  std::string text;
  for (std::size_t q = 0; q < kWeightedQuantities.size(); ++q) {
    const bool volume = q + 1 == kWeightedQuantities.size();
    TextTable table{{std::string(kWeightedQuantities[q]) + (volume ? " m3" : " m")}, {}};
    for (const char* name : kWeightedPercentileNames) table.headings.push_back(name);
    for (const WeightedSizes& sizes : summary.sizes) {
      table.rows.push_back({heading_of(sizes.weighting)});
      for (const EstimatedValue& estimate : sizes.percentiles[q]) {
        table.rows.back().push_back(estimate_text(estimate));
      }
    }
    text += "\n" + table.text();
  }
  return text;
}

std::string fractions_text(const CorrectedSchemeFractions& scheme) {
  TextTable table{{scheme.scheme, "found %", "corrected %"}, {}};
  for (const CorrectedFraction& one : scheme.fractions) {
    table.rows.push_back({one.name, percent_text(one.found), percent_text(one.corrected)});
  }
  return table.text();
}

}  // namespace

std::string heading_of(SizeWeighting weighting) {
  if (weighting == SizeWeighting::kCorrected) return "by number, corrected";
  return "by " + name_of(weighting);
}

std::string describe_visibility_correction(const VisibilityCorrection& correction) {
  const auto words = [&](double size) {
    return format_percent(correction.inclusion_probability(size), 0) +
           " of the blocks with I = " + format_rounded(size, 2) + " m";
  };
  return "About " + words(correction.middle_size) + " and " + words(2.0 * correction.middle_size) +
         " are found; others show too little of their surface or lie wholly under other blocks.";
}

std::string describe_long_axes(const LongAxisTrends& trends) {
  if (trends.trends.empty()) return "No block is elongated enough to have a trend.";
  std::string text = "Long axes of " + format_count(trends.trends.size(), "block") +
                     " (L/I at least " + format_rounded(kLeastElongation, 2) + "): ";
  if (std::isfinite(trends.mean.direction)) {
    double trend = trends.mean.direction * kDegreesPerRadian;
    if (trend < 0.0) trend += 180.0;
    text += "mean trend " + format_decimals(trend, 0) + " degrees, ";
  }
  return text + "mean resultant length " + format_decimals(trends.mean.resultant_length, 2) +
         (trends.p_value < kSignificanceLevel ? "; the trends are not uniform"
                                              : "; no preferred trend can be shown") +
         " (Rayleigh test of the doubled angles, p " + format_p_value(trends.p_value) + ").";
}

std::string format_scanned_deposit(const ScannedDepositSummary& summary) {
  std::string text = "\nScanned deposit: " + format_count(summary.blocks, "block") +
                     " found, about " + format_rounded(summary.corrected_blocks.value, 3) + " (" +
                     format_rounded(summary.corrected_blocks.interval.low, 3) + " to " +
                     format_rounded(summary.corrected_blocks.interval.high, 3) +
                     ") with those that do not show\n" +
                     describe_visibility_correction(summary.correction) + "\n";
  text += sizes_text(summary);
  for (const CorrectedSchemeFractions& scheme : summary.schemes) {
    text += "\n" + fractions_text(scheme);
  }
  return text + "\n" + describe_long_axes(summary.long_axes) + "\n";
}

}  // namespace clast
