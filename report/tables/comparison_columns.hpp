#pragma once
/// The columns of the tables of `clast compare`, each declared once; `run_columns` has those of
/// runs.csv. A test compares them with docs/formats.md.
#include <vector>

#include "report/charts/form_responses.hpp"
#include "study/compare/barrier_passages.hpp"
#include "study/compare/design_effects.hpp"
#include "study/compare/ensemble_effects.hpp"
#include "study/compare/mass_mobility.hpp"
#include "study/compare/profiles.hpp"
#include "study/compare/realisation_deposits.hpp"
#include "study/compare/realisation_figures.hpp"
#include "study/compare/run_columns.hpp"
#include "study/compare/shape_trends.hpp"

namespace clast::report_detail {

/// A ground zone in a ground set of a results file.
struct ZoneOfSet {
  std::size_t file = 0;
  std::size_t set = 0;
  std::size_t zone = 0;
};
/// A group and where its runs came to rest.
struct GroupDeposit {
  const Group& group;
  const DepositGroup& deposit;
};
/// An impact and its run.
struct RunImpact {
  const RunRow& run;
  const Impact& impact;
};

/// A run whose block stayed among others.
struct RunStay {
  const RunRow& run;
  const StayRecord& stay;
};

/// The energy of a realisation at one instant.
struct EnergyOfFile {
  std::uint32_t file = 0;
  std::uint32_t realisation = 0;  ///< from 0
  const EnergyRecord& record;
};

/// The share of one factor, or of all interactions, in the variance of an outcome.
struct EffectShare {
  const DesignEffects& effects;
  const OutcomeEffects& outcome;
  std::string factor;  ///< "interactions" for these
  std::size_t levels;  ///< 0 for these
  const VarianceShare& share;
};

/// An outcome against a property of the blocks, and the file.
struct TrendOfFile {
  std::uint32_t file = 0;
  const ShapeTrend& trend;
};

/// An outcome of one form.
struct ResponseOfForm {
  const OutcomeOfForms& outcome;
  const FormOutcome& form;
};

/// A passage, and all that has passed with it in its realisation.
struct PassedSoFar {
  const RealisationPassages& realisation;
  BlockPassage passage;
  std::uint64_t passed = 0;
  double mass = 0.0;    ///< kg
  double volume = 0.0;  ///< m^3
  double energy = 0.0;  ///< J
};

const TableColumns<BarrierGroup>& barrier_columns();
const TableColumns<ComparisonRow<CrossingRow>>& crossing_columns();
const TableColumns<ComparisonRow<GroupDeposit>>& deposit_columns();
const TableColumns<ComparisonRow<Difference>>& difference_columns();
const TableColumns<EffectShare>& effect_columns();
const TableColumns<EnergyOfFile>& energy_columns();
const TableColumns<ComparisonRow<ParameterEffect>>& ensemble_columns();
const TableColumns<ComparisonRow<ZoneOfSet>>& ground_set_columns();
const TableColumns<ComparisonRow<RunImpact>>& impact_columns();
const TableColumns<ComparisonRow<MeasuredGroup>>& measured_columns();
const TableColumns<Mobility>& mobility_columns();
const TableColumns<ComparisonRow<PassedSoFar>>& passage_curve_columns();
const TableColumns<ComparisonRow<RealisationPassages>>& passage_columns();
const TableColumns<ComparisonRow<ProfileBin>>& profile_columns();
const TableColumns<RealisationDeposit>& realisation_columns();
const TableColumns<FigureDifference>& realisation_difference_columns();
const TableColumns<FigureOfFile>& realisation_figure_columns();
const TableColumns<ResponseOfForm>& response_columns();
const TableColumns<ComparisonRow<RunStay>>& stay_columns();
const TableColumns<TrendOfFile>& trend_columns();

/// The rows of tables that no list of the comparison holds.
std::vector<GroupDeposit> deposit_rows(const Comparison& comparison);
/// They refer to `all`.
std::vector<EffectShare> effect_rows(const std::vector<DesignEffects>& all);
/// In order of file, realisation and time.
std::vector<EnergyOfFile> energy_rows(const Comparison& comparison);
std::vector<ZoneOfSet> ground_set_rows(const Comparison& comparison);
std::vector<RunImpact> impact_rows(const Comparison& comparison);
/// In order of barrier, file, realisation and time. They refer to `all`.
std::vector<PassedSoFar> passage_curve_rows(const std::vector<RealisationPassages>& all);
/// They refer to `all`.
std::vector<ResponseOfForm> response_rows(const std::vector<OutcomeOfForms>& all);
std::vector<RunStay> stay_rows(const Comparison& comparison);
/// They refer to `all`.
std::vector<TrendOfFile> trend_rows(const std::vector<ShapeTrends>& all);

/// The rows of a list in a comparison.
template <class Item>
std::vector<ComparisonRow<Item>> rows_of(const Comparison& comparison,
                                         const std::vector<Item>& items) {
  std::vector<ComparisonRow<Item>> rows;
  for (const Item& item : items) rows.push_back({comparison, item});
  return rows;
}

}  // namespace clast::report_detail
