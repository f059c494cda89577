// Tables of effects: factors of a design, and drawn ground parameters.
#include <cmath>

#include "report/tables/comparison_columns.hpp"

namespace clast {

using namespace report_detail;
namespace {

/// The share of one factor, or of all interactions, in the variance of an outcome.
struct EffectShare {
  const DesignEffects& effects;
  const OutcomeEffects& outcome;
  std::string factor;  ///< "interactions" for these
  std::size_t levels;  ///< 0 for these
  const VarianceFraction& share;
};

/// An outcome against a property of the blocks, and the file.
struct TrendOfFile {
  std::uint32_t file = 0;
  const ShapeTrend& trend;
};

struct ResponseOfForm {
  const OutcomeByShape& outcome;
  const ShapeOutcome& form;
};

const TableColumns<EffectShare>& effect_columns() {
  using Row = EffectShare;
  const char* estimated =
      "fraction of the variance, for the population from which the levels "
      "were drawn, with its 95 % interval";
  static const TableColumns<Row> columns = {
      {"file", "", "number of the results file",
       [](const Row& row) { return std::uint64_t{row.effects.file + 1}; }},
      {"outcome", "", "`runout`, `lateral angle`, `largest energy` or `passing NAME` of a barrier",
       [](const Row& row) { return row.outcome.outcome; }},
      {"mean", "m, rad, J or fraction", "mean over all runs",
       [](const Row& row) { return row.outcome.mean; }},
      {"standard_deviation", "m, rad, J or fraction", "standard deviation over all runs",
       [](const Row& row) { return row.outcome.deviation; }},
      {"factor", "",
       "`form`, `mass`, `block`, `orientation`, `release point`, `ground`, or `interactions` of "
       "these",
       [](const Row& row) { return row.factor; }},
      {"levels", "", "number of levels of the factor; 0 for interactions",
       [](const Row& row) { return std::uint64_t{row.levels}; }},
      {"share_of_design", "",
       "first-order Sobol index of the runs as they are, exact; empty unless "
       "every combination was run once",
       [](const Row& row) { return row.share.design_fraction; }},
      {"share", "", estimated, [](const Row& row) { return row.share.estimate; }},
      {"share_low", "", estimated, [](const Row& row) { return row.share.interval.low; }},
      {"share_high", "", estimated, [](const Row& row) { return row.share.interval.high; }}};
  return columns;
}

const TableColumns<TrendOfFile>& trend_columns() {
  using Row = TrendOfFile;
  const char *unit = "m, rad, J or fraction",
             *halves =
                 "mean outcome of the upper half of the blocks minus that of the lower "
                 "half";
  static const TableColumns<Row> columns = {
      {"file", "", "number of the results file",
       [](const Row& row) { return std::uint64_t{row.file + 1}; }},
      {"outcome", "", "`runout`, `lateral angle`, `largest energy` or `passing NAME` of a barrier",
       [](const Row& row) { return row.trend.outcome; }},
      {"property", "",
       "property of the blocks: `I/L`, `S/L`, `convexity`, `rounding` "
       "(Minkowski radius over S) or `mass`",
       [](const Row& row) { return row.trend.property; }},
      {"blocks", "", "number of compared blocks",
       [](const Row& row) { return std::uint64_t{row.trend.blocks}; }},
      {"runs", "", "number of runs of these blocks",
       [](const Row& row) { return std::uint64_t{row.trend.runs}; }},
      {"rank_correlation", "",
       "rank correlation of the property and the mean rank of the outcome "
       "within release points",
       [](const Row& row) { return row.trend.trend.statistic; }},
      {"p_value", "",
       "p-value of the trend, two-sided, from permutations of the property "
       "between blocks",
       [](const Row& row) { return row.trend.trend.p_value; }},
      {"p_corrected", "", "`p_value` with Holm's correction for all properties of the outcome",
       [](const Row& row) { return row.trend.corrected_p; }},
      {"upper_half_from", "kg or ratio",
       "smallest value of the property in the upper half of the blocks",
       [](const Row& row) { return row.trend.limit; }},
      {"difference", unit, halves, [](const Row& row) { return row.trend.halves.estimate; }},
      {"difference_low", unit, "95 % interval of the difference",
       [](const Row& row) { return row.trend.halves.interval->low; }},
      {"difference_high", unit, "95 % interval of the difference",
       [](const Row& row) { return row.trend.halves.interval->high; }},
      {"difference_p", "", "p-value of the hypothesis of no difference, two-sided",
       [](const Row& row) { return *row.trend.halves.p_value; }},
      {"equivalence_p", "",
       "p-value of a difference as large as the margin; below 0.05: the "
       "difference is within the margin. Only for the runout, if a margin is "
       "given",
       [](const Row& row) { return row.trend.equivalence.value_or(NAN); }},
      {"scatter", unit, "standard deviation of a run within its half and release point",
       [](const Row& row) { return row.trend.halves.scatter; }},
      {"design_effect", "",
       "variance of the difference over its variance for the same number of "
       "independent runs",
       [](const Row& row) { return row.trend.halves.design_effect; }},
      {"smallest_difference", unit,
       "smallest difference that a campaign like this finds in 80 % of cases, "
       "at 5 %",
       [](const Row& row) { return row.trend.detectable_difference; }},
      {"runs_needed", "",
       "number of runs that find a difference as large as the margin in 80 % "
       "of cases, with blocks and points in proportion",
       [](const Row& row) { return row.trend.runs_needed.value_or(NAN); }}};
  return columns;
}

const TableColumns<ComparisonRow<ParameterEffect>>& ensemble_columns() {
  using Row = ComparisonRow<ParameterEffect>;
  using Effect = ParameterEffect;
  const char *drawn = "smallest, median and largest drawn value", *outcome_unit = "m or fraction",
             *over = "5 % quantile, median and 95 % quantile of the outcome over members";
  static const TableColumns<Row> columns = {
      {"file", "", "number of the results file", [](const Row& row) { return row->file + 1; }},
      {"block_group", "", "block group of the runs; empty: blocks in no group", &Effect::group},
      {"zone", "", "name of the ground zone", &Effect::zone},
      {"parameter", "", "name of the parameter, as in ground_sets.csv", &Effect::parameter},
      {"members", "", "number of members of the ensemble that have the outcome", &Effect::members},
      {"drawn_low", "", drawn, &Effect::low},
      {"drawn_median", "", drawn, &Effect::median},
      {"drawn_high", "", drawn, &Effect::high},
      {"outcome", "",
       "`mean runout` of runs at rest, or `past NAME`, the fraction of runs "
       "past a barrier",
       &Effect::outcome},
      {"outcome_p5", outcome_unit, over, &Effect::outcome_p5},
      {"outcome_median", outcome_unit, over, &Effect::outcome_median},
      {"outcome_p95", outcome_unit, over, &Effect::outcome_p95},
      {"rank_correlation", "", "Spearman's rank correlation of drawn value and outcome",
       [](const Row& row) { return row->correlation ? row->correlation->statistic : NAN; }},
      {"p_value", "", "p-value of the rank correlation, two-sided",
       [](const Row& row) { return row->correlation ? row->correlation->p_value : NAN; }},
      {"first_order", "",
       "fraction of the variance of the outcome that is due to the parameter "
       "alone; empty for fewer than 40 members",
       [](const Row& row) { return row->first_order.value_or(NAN); }}};
  return columns;
}

std::vector<EffectShare> effect_rows(const ComparisonAnalyses& analyses) {
  std::vector<EffectShare> shares;
  for (const DesignEffects& effects : analyses.design_effects()) {
    for (const OutcomeEffects& outcome : effects.outcomes) {
      for (std::size_t f = 0; f < effects.factors.size(); ++f) {
        shares.push_back({effects, outcome, effects.factors[f].name, effects.factors[f].levels,
                          outcome.shares.factors[f]});
      }
      shares.push_back({effects, outcome, "interactions", 0, outcome.shares.interactions});
    }
  }
  return shares;
}

const TableColumns<ResponseOfForm>& response_columns() {
  using Row = ResponseOfForm;
  const char* unit = "m, rad, J or fraction";
  static const TableColumns<Row> columns = {
      {"file", "", "number of the results file",
       [](const Row& row) { return std::uint64_t{row.outcome.file + 1}; }},
      {"outcome", "", "`runout`, `lateral angle`, `largest energy` or `passing NAME` of a barrier",
       [](const Row& row) { return row.outcome.outcome; }},
      {"form", "", "block of the library", [](const Row& row) { return row.form.block_id; }},
      {"i_over_l", "", "I/L", [](const Row& row) { return row.form.axes.I / row.form.axes.L; }},
      {"s_over_l", "", "S/L", [](const Row& row) { return row.form.axes.S / row.form.axes.L; }},
      {"made", "", "1 if `clast vary` made this form, 0 for a scanned block",
       [](const Row& row) { return row.form.is_generated; }},
      {"runs", "", "number of runs of the form",
       [](const Row& row) { return std::uint64_t{row.form.runs}; }},
      {"mean", unit, "mean over these runs", [](const Row& row) { return row.form.mean; }},
      {"standard_deviation", unit, "standard deviation over these runs",
       [](const Row& row) { return row.form.deviation; }}};
  return columns;
}

std::vector<ResponseOfForm> response_rows(const ComparisonAnalyses& analyses) {
  std::vector<ResponseOfForm> rows;
  for (const OutcomeByShape& outcome : analyses.shape_outcomes()) {
    for (const ShapeOutcome& form : outcome.forms) rows.push_back({outcome, form});
  }
  return rows;
}

std::vector<TrendOfFile> trend_rows(const ComparisonAnalyses& analyses) {
  std::vector<TrendOfFile> rows;
  for (const ShapeTrends& file : analyses.shape_trends()) {
    for (const ShapeTrend& trend : file.trends) rows.push_back({file.file, trend});
  }
  return rows;
}

}  // namespace

std::vector<ComparisonTable> report_detail::make_effect_tables() {
  return {
      make_comparison_table("ensemble", ensemble_columns(), &ComparisonAnalyses::ensemble_effects),
      make_comparison_table("effects", effect_columns(), effect_rows),
      make_comparison_table("trends", trend_columns(), trend_rows),
      make_comparison_table("responses", response_columns(), response_rows)};
}

}  // namespace clast
