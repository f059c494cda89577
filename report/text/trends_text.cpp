#include "report/text/trends_text.hpp"

#include <algorithm>
#include <cmath>

#include "core/comma_separated.hpp"
#include "core/number_text.hpp"
#include "report/text/capital.hpp"

namespace clast {
namespace {

using namespace report_detail;

constexpr double kTrendLevel = 0.05;

std::string p_text(double p) {
  return p < 1e-3 ? "p < 0.001" : "p = " + format_significant(p, p < 0.1 ? 1 : 2);
}

std::string trend_value(double value, const std::string& unit) {
  return format_significant(value, 2) + (unit.empty() ? "" : " " + unit);
}

/// A number of runs, two digits of it.
std::string about(double runs) {
  const double digits = std::pow(10.0, std::floor(std::log10(std::max(runs, 10.0))) - 1.0);
  return format_decimals(std::round(runs / digits) * digits, 0);
}

/// "Runout rises with S/L (...) and falls with rounding (...); no significant trend with mass."
std::string trend_sentence(const std::vector<const ShapeTrend*>& outcome) {
  std::vector<std::string> found, none;
  for (const ShapeTrend* trend : outcome) {
    if (trend->corrected_p >= kTrendLevel) {
      none.push_back(trend->property);
      continue;
    }
    found.push_back(std::string(trend->trend.statistic > 0.0 ? "rises" : "falls") + " with " +
                    trend->property + " (rank correlation " +
                    format_decimals(trend->trend.statistic, 2) + ", " + p_text(trend->corrected_p) +
                    ")");
  }
  const std::string& name = outcome.front()->outcome;
  if (found.empty()) return name + " has no significant trend with " + comma_separated(none) + ".";
  return name + " " + comma_separated(found) +
         (none.empty() ? "" : "; no significant trend with " + comma_separated(none)) + ".";
}

/// Difference of the halves by one property, what it means, and what could be found.
std::string halves_sentence(const ShapeTrend& trend, const std::optional<double>& margin) {
  const CrossedDifference& halves = trend.halves;
  std::string text = "if the blocks are divided into two halves by " + trend.property + ", the " +
                     trend.outcome + " differs by " + trend_value(halves.estimate, trend.unit) +
                     " (" + format_significant(halves.interval->low, 2) + " to " +
                     format_significant(halves.interval->high, 2) + ")";
  if (trend.equivalence) {
    const std::string limit = trend_value(*margin, trend.unit);
    const bool beyond = std::max(halves.interval->low, -halves.interval->high) > *margin;
    const std::string p = " (" + p_text(*trend.equivalence) + ")";
    text += *trend.equivalence < kTrendLevel
                ? ", within +-" + limit + ": the effect is negligible" + p
            : beyond ? ", more than +-" + limit
                     : ", but it is not shown to be within +-" + limit + p;
  }
  text += "; a campaign of this size detects a difference of " +
          trend_value(trend.detectable_difference, trend.unit) + " in 80 % of cases";
  if (trend.runs_needed) {
    text += ", and " + trend_value(*margin, trend.unit) + " with " + about(*trend.runs_needed) +
            " runs, with more blocks and release points in proportion";
  }
  return text + ".";
}

/// Why nothing can be said of a margin that was given.
std::string why_not_known(const PlannedPower& plan) {
  const std::string begin = "the dry run can't say whether this campaign detects a difference of " +
                            trend_value(*plan.margin, "m");
  if (plan.runs == 0) {
    return begin +
           ": blocks are persistent, so the runs depend on each other; compare the realisations of "
           "two campaigns";
  }
  if (plan.blocks < kMinBlocksForPower) {
    return begin + " with " + format_count(plan.blocks, "block") +
           ": it compares two halves of the blocks, which requires " +
           std::to_string(kMinBlocksForPower) + " or more";
  }
  if (plan.trial_runs < 2) {
    return begin + ": " + (plan.trial_runs == 0 ? "no trial run" : "only one trial run") +
           " came to rest within the time limit, too few to estimate the scatter of runouts";
  }
  return begin + ": the runouts of " + format_count(plan.trial_runs, "trial run") +
         " are all equal";
}

}  // namespace

std::vector<std::string> describe_trends(const std::vector<ShapeTrends>& trends,
                                         const std::optional<double>& margin) {
  std::vector<std::string> sentences;
  for (const ShapeTrends& file : trends) {
    const std::string where =
        trends.size() > 1 ? "file " + std::to_string(file.file + 1) + ": " : "";
    for (std::size_t i = 0; i < file.trends.size();) {
      std::vector<const ShapeTrend*> outcome;
      const std::string& name = file.trends[i].outcome;
      for (; i < file.trends.size() && file.trends[i].outcome == name; ++i) {
        outcome.push_back(&file.trends[i]);
      }
      sentences.push_back(capitalized(where + trend_sentence(outcome)));
      if (name != "runout") continue;
      for (const ShapeTrend* trend : outcome) {
        sentences.push_back(capitalized(where + halves_sentence(*trend, margin)));
      }
    }
  }
  return sentences;
}

std::string describe_planned_power(const PlannedPower& plan) {
  if (!plan.is_known()) return plan.margin ? why_not_known(plan) : "";
  std::string text = "a difference in runout of " + trend_value(plan.detectable_difference(), "m") +
                     " between two halves of the blocks is detected in 80 % of such campaigns, if "
                     "the standard deviation of runout is " +
                     trend_value(plan.runout_deviation, "m") + " as in " +
                     format_count(plan.trial_runs, "trial run") + " and " +
                     format_significant(100.0 * kAssumedIntraclassCorrelation, 2) +
                     " % of its variance is explained by the block (design effect " +
                     format_significant(plan.design_effect(), 2) + ")";
  if (plan.margin) {
    text += "; " + trend_value(*plan.margin, "m") + " takes " + about(plan.runs_needed()) +
            " runs, with blocks in proportion";
  }
  return text;
}

}  // namespace clast
