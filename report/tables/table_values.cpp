#include "report/tables/table_values.hpp"

#include <functional>
#include <utility>

#include "core/error.hpp"
#include "core/listed.hpp"
#include "report/tables/comparison_columns.hpp"
#include "report/tables/population_columns.hpp"

namespace clast {

using namespace report_detail;
namespace {

template <class Source>
using NamedTables = std::vector<std::pair<std::string, std::function<TableValues(const Source&)>>>;

const NamedTables<Comparison>& comparison_tables() {
  static const NamedTables<Comparison> tables = {
      {"runs", [](const auto& all) { return values_of(run_columns(), rows_of(all, all.rows)); }},
      {"barriers", [](const auto& all) { return values_of(barrier_columns(), all.barriers); }},
      {"crossings",
       [](const auto& all) { return values_of(crossing_columns(), rows_of(all, all.crossings)); }},
      {"deposits",
       [](const auto& all) {
         return values_of(deposit_columns(), rows_of(all, deposit_rows(all)));
       }},
      {"impacts",
       [](const auto& all) { return values_of(impact_columns(), rows_of(all, impact_rows(all))); }},
      {"ground_sets",
       [](const auto& all) {
         return values_of(ground_set_columns(), rows_of(all, ground_set_rows(all)));
       }},
      {"effects",
       [](const auto& all) {
         return values_of(effect_columns(), effect_rows(design_effects(all)));
       }},
      {"responses",
       [](const auto& all) {
         return values_of(response_columns(), response_rows(outcomes_of_forms(all)));
       }},
      {"trends",
       [](const auto& all) { return values_of(trend_columns(), trend_rows(shape_trends(all))); }},
      {"ensemble",
       [](const auto& all) {
         return values_of(ensemble_columns(), rows_of(all, ensemble_effects(all)));
       }},
      {"stays",
       [](const auto& all) { return values_of(stay_columns(), rows_of(all, stay_rows(all))); }},
      {"realisations",
       [](const auto& all) {
         return values_of(realisation_columns(), realisation_deposits(all).realisations);
       }},
      {"realisation_figures",
       [](const auto& all) {
         return values_of(realisation_figure_columns(),
                          figures_of_files(realisation_deposits(all).realisations).files);
       }},
      {"realisation_differences",
       [](const auto& all) {
         return values_of(realisation_difference_columns(),
                          figures_of_files(realisation_deposits(all).realisations).differences);
       }},
      {"passages",
       [](const auto& all) {
         return values_of(passage_columns(), rows_of(all, barrier_passages(all)));
       }},
      {"passage_curves",
       [](const auto& all) {
         const std::vector<RealisationPassages> passages = barrier_passages(all);
         return values_of(passage_curve_columns(), rows_of(all, passage_curve_rows(passages)));
       }},
      {"energies", [](const auto& all) { return values_of(energy_columns(), energy_rows(all)); }},
      {"mobility",
       [](const auto& all) { return values_of(mobility_columns(), mass_mobility(all)); }},
      {"differences",
       [](const auto& all) {
         return values_of(difference_columns(), rows_of(all, all.differences));
       }},
      {"profiles",
       [](const auto& all) { return values_of(profile_columns(), rows_of(all, profiles(all))); }},
      {"measured", [](const auto& all) {
         const std::vector<MeasuredGroup> none;
         return values_of(measured_columns(),
                          rows_of(all, all.measured ? all.measured->groups : none));
       }}};
  return tables;
}

std::vector<BlockRow> block_rows(const PopulationReport& report) {
  std::vector<BlockRow> rows;
  for (const ReportedPopulation& reported : report.populations) {
    for (const MeasuredBlock& block : reported.population.blocks) {
      rows.push_back({reported.population.name, block});
    }
  }
  return rows;
}

const NamedTables<PopulationReport>& population_tables() {
  static const NamedTables<PopulationReport> tables = {
      {"classes",
       [](const auto& report) {
         return values_of(class_columns(report.options.chosen_schemes(), report.options.limits),
                          block_rows(report));
       }},
      {"shares", [](const auto& report) { return values_of(share_columns(), share_rows(report)); }},
      {"sizes", [](const auto& report) { return values_of(size_columns(), size_rows(report)); }},
      {"tests", [](const auto& report) { return values_of(test_columns(), test_rows(report)); }}};
  return tables;
}

template <class Source>
std::vector<std::string> names_of(const NamedTables<Source>& tables) {
  std::vector<std::string> names;
  for (const auto& [name, values] : tables) names.push_back(name);
  return names;
}

template <class Source>
TableValues table_named(const NamedTables<Source>& tables, const std::string& name,
                        const Source& source) {
  for (const auto& [known, values] : tables) {
    if (known == name) return values(source);
  }
  throw InputError("\"" + name + "\" is no table; there are " + listed(names_of(tables)));
}

}  // namespace

const std::vector<std::string>& comparison_table_names() {
  static const std::vector<std::string> names = names_of(comparison_tables());
  return names;
}

TableValues comparison_table(const Comparison& comparison, const std::string& name) {
  return table_named(comparison_tables(), name, comparison);
}

const std::vector<std::string>& population_table_names() {
  static const std::vector<std::string> names = names_of(population_tables());
  return names;
}

TableValues population_table(const PopulationReport& report, const std::string& name) {
  return table_named(population_tables(), name, report);
}

}  // namespace clast
