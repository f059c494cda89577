#include "report/text/measured_text.hpp"

#include "core/number_text.hpp"
#include "report/text/capital.hpp"
#include "report/text/plain_numbers.hpp"

namespace clast {

using namespace report_detail;

std::vector<std::string> describe_measured_stops(const Comparison& comparison) {
  std::vector<std::string> sentences;
  if (!comparison.measured) return sentences;
  for (const MeasuredStopGroup& group : comparison.measured->groups) {
    const RunGroup& runs = comparison.groups[group.group];
    const std::string who = runs.kind == RunGroupKind::kAll      ? "all blocks"
                            : runs.kind == RunGroupKind::kGarcia ? runs.key + " blocks"
                                                                 : "block " + runs.key;
    const double gap = group.medians.estimate;
    const int decimals = decimals_of_length(gap, group.medians.interval);
    const std::string medians =
        "half stopped before " + format_length(group.quartiles.median, decimals) +
        " in the field, " + format_length(group.simulated_quartiles.median, decimals) +
        " simulated";
    const Interval interval = group.medians.interval.value_or(Interval{});
    std::string verdict;
    switch (judge_stop_agreement(group)) {
      case ContrastVerdict::kTooFewValues:
        verdict =
            format_count(group.measured, "measured stop") + ", too few for a test; " + medians;
        break;
      case ContrastVerdict::kUntested:
        verdict = medians + "; with one realisation, significance cannot be tested";
        break;
      case ContrastVerdict::kSignificant:
        verdict = interval.low > 0.0
                      ? format_length(gap, decimals) + " farther in the field than simulated (" +
                            format_length_interval(interval, decimals) + ")"
                      : format_length(-gap, decimals) + " less far in the field than simulated (" +
                            format_length_interval({-interval.high, -interval.low}, decimals) + ")";
        break;
      case ContrastVerdict::kDistributionDiffers:
        verdict = "the medians agree, but the distributions differ; " + medians;
        break;
      default:
        verdict = "no significant difference between field and simulation; " + medians +
                  " (a difference of " + format_length_interval(interval, decimals) + ")";
    }
    sentences.push_back(capitalized(who) + ": " + verdict + ".");
  }
  return sentences;
}

}  // namespace clast
