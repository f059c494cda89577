// What moved the outcomes: factors of a design, and drawn ground parameters.
#include <cmath>

#include "report/tables/comparison_columns.hpp"
#include "report/tables/group_tables.hpp"

namespace clast {

using namespace report_detail;

const TableColumns<EffectShare>& report_detail::effect_columns() {
  using Row = EffectShare;
  const char* estimated = "of the population that the levels were drawn from; 95 % interval";
  static const TableColumns<Row> columns = {
      {"file", "", "number of the results file",
       [](const Row& row) { return std::uint64_t{row.effects.file + 1}; }},
      {"outcome", "", "`runout`, `lateral angle`, `largest energy` or `passing NAME` of a barrier",
       [](const Row& row) { return row.outcome.outcome; }},
      {"mean", "m, rad, J or share", "over all runs",
       [](const Row& row) { return row.outcome.mean; }},
      {"standard_deviation", "m, rad, J or share", "of the runs",
       [](const Row& row) { return row.outcome.deviation; }},
      {"factor", "",
       "`form`, `mass`, `block`, `orientation`, `release point`, `ground`, or `interactions` of "
       "these",
       [](const Row& row) { return row.factor; }},
      {"levels", "", "of the factor; 0 for interactions",
       [](const Row& row) { return std::uint64_t{row.levels}; }},
      {"share_of_design", "", "first-order Sobol index of the runs as they are, exact",
       [](const Row& row) { return row.share.of_design; }},
      {"share", "", estimated, [](const Row& row) { return row.share.estimate; }},
      {"share_low", "", estimated, [](const Row& row) { return row.share.interval.low; }},
      {"share_high", "", estimated, [](const Row& row) { return row.share.interval.high; }}};
  return columns;
}

const TableColumns<ComparisonRow<ParameterEffect>>& report_detail::ensemble_columns() {
  using Row = ComparisonRow<ParameterEffect>;
  using Effect = ParameterEffect;
  const char *drawn = "drawn values", *outcome_unit = "m or share", *over = "over members";
  static const TableColumns<Row> columns = {
      {"file", "", "number of the results file", [](const Row& row) { return row->file + 1; }},
      {"block_group", "", "whose runs are meant; empty: of blocks in no group", &Effect::group},
      {"zone", "", "name of the ground zone", &Effect::zone},
      {"parameter", "", "name of the parameter, as in ground_sets.csv", &Effect::parameter},
      {"members", "", "members of the ensemble that have the outcome", &Effect::members},
      {"drawn_low", "", drawn, &Effect::low},
      {"drawn_median", "", drawn, &Effect::median},
      {"drawn_high", "", drawn, &Effect::high},
      {"outcome", "", "`mean runout` of runs at rest, or `past NAME`, the share past a barrier",
       &Effect::outcome},
      {"outcome_p5", outcome_unit, over, &Effect::outcome_p5},
      {"outcome_median", outcome_unit, over, &Effect::outcome_median},
      {"outcome_p95", outcome_unit, over, &Effect::outcome_p95},
      {"rank_correlation", "", "Spearman's, of drawn value and outcome",
       [](const Row& row) { return row->correlation ? row->correlation->statistic : NAN; }},
      {"p_value", "", "of the rank correlation, two-sided",
       [](const Row& row) { return row->correlation ? row->correlation->p_value : NAN; }},
      {"first_order", "",
       "share of the outcome's variance that goes with the parameter alone; from 40 members on",
       [](const Row& row) { return row->first_order.value_or(NAN); }}};
  return columns;
}

std::vector<EffectShare> report_detail::effect_rows(const std::vector<DesignEffects>& all) {
  std::vector<EffectShare> shares;
  for (const DesignEffects& effects : all) {
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

std::string effects_csv(const Comparison& comparison) {
  return csv_of(effect_columns(), effect_rows(design_effects(comparison)));
}

std::string ensemble_csv(const Comparison& comparison) {
  return csv_of(ensemble_columns(), rows_of(comparison, ensemble_effects(comparison)));
}

}  // namespace clast
