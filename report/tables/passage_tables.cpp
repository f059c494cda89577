// The tables of what passes barriers together.
#include "report/tables/comparison_columns.hpp"

namespace clast {

using namespace report_detail;
namespace {

/// A passage, and all that has passed with it in its realisation.
struct PassedSoFar {
  const RealisationCrossings& realisation;
  BlockCrossing passage;
  std::uint64_t passed = 0;
  double mass = 0.0;    ///< kg
  double volume = 0.0;  ///< m^3
  double energy = 0.0;  ///< J
};

double mass_of(const BlockCrossing& passage) { return passage.mass; }
double volume_of(const BlockCrossing& passage) { return passage.volume; }
double energy_of(const BlockCrossing& passage) { return passage.energy; }

const TableColumns<ComparisonRow<RealisationCrossings>>& passage_columns() {
  using Row = ComparisonRow<RealisationCrossings>;
  const auto sum = [](double (*value)(const BlockCrossing&)) {
    return [value](const Row& row) { return row->sum(value); };
  };
  const auto peak = [](WindowMaximum RealisationCrossings::*of, double WindowMaximum::*part) {
    return [of, part](const Row& row) { return ((*row).*of).*part; };
  };
  const char* from = "start of the first window with this maximum";
  static const TableColumns<Row> columns = {
      {"barrier", "", "name of the barrier; for a ring as in barriers.csv",
       [](const Row& row) { return row.comparison.lines[row->line].name; }},
      {"realisation", "", "number of the realisation, from 1",
       [](const Row& row) { return row->realisation + 1; }},
      {"blocks", "", "number of released blocks", &RealisationCrossings::blocks},
      {"passed", "",
       "number of these blocks that passed; each block counts once, at its "
       "`counted` crossing",
       [](const Row& row) { return row->passages.size(); }},
      {"mass_kg", "kg", "mass of the blocks that passed", sum(mass_of)},
      {"volume_m3", "m3", "volume of the blocks that passed, without the space between them",
       sum(volume_of)},
      {"energy_j", "J", "kinetic energy, translational and rotational, of all passages",
       sum(energy_of)},
      {"largest_energy_j", "J", "largest kinetic energy of a single passage",
       &RealisationCrossings::largest_energy},
      {"first_s", "s",
       "time of the first and of the last passage, since the first release of "
       "the realisation",
       &RealisationCrossings::first},
      {"last_s", "s",
       "time of the first and of the last passage, since the first release of "
       "the realisation",
       &RealisationCrossings::last},
      {"duration_s", "s", "time from the first to the last passage",
       [](const Row& row) { return row->last() - row->first(); }},
      {"window_s", "s", "length of the time window over which the following maxima are taken",
       [](const Row&) { return kPassageWindow; }},
      {"most_blocks", "", "largest number of blocks that pass within one window",
       peak(&RealisationCrossings::max_blocks_in_window, &WindowMaximum::value)},
      {"most_blocks_from_s", "s", from,
       peak(&RealisationCrossings::max_blocks_in_window, &WindowMaximum::from)},
      {"most_mass_kg", "kg", "largest mass of the blocks that pass within one window",
       peak(&RealisationCrossings::max_mass_in_window, &WindowMaximum::value)},
      {"most_mass_from_s", "s", from,
       peak(&RealisationCrossings::max_mass_in_window, &WindowMaximum::from)},
      {"most_energy_j", "J",
       "largest sum of kinetic energies of the passages within one time window",
       peak(&RealisationCrossings::max_energy_in_window, &WindowMaximum::value)},
      {"most_energy_from_s", "s", from,
       peak(&RealisationCrossings::max_energy_in_window, &WindowMaximum::from)},
      {"file", "", "number of the results file", [](const Row& row) { return row->file + 1; }}};
  return columns;
}

const TableColumns<ComparisonRow<PassedSoFar>>& passage_curve_columns() {
  using Row = ComparisonRow<PassedSoFar>;
  const auto run = [](const Row& row) -> const RunRow& {
    return row.comparison.rows[row->passage.row];
  };
  static const TableColumns<Row> columns = {
      {"barrier", "", "name of the barrier; for a ring as in barriers.csv",
       [](const Row& row) { return row.comparison.lines[row->realisation.line].name; }},
      {"realisation", "", "number of the realisation, from 1",
       [](const Row& row) { return row->realisation.realisation + 1; }},
      {"time_s", "s", "time since the first release of the realisation",
       [](const Row& row) { return row->passage.time; }},
      {"run", "", "number of the run in its campaign, from 0",
       [=](const Row& row) { return run(row).record->run; }},
      {"passed", "", "number of blocks that have passed, including this block",
       &PassedSoFar::passed},
      {"mass_kg", "kg", "mass of these blocks", &PassedSoFar::mass},
      {"volume_m3", "m3", "volume of these blocks", &PassedSoFar::volume},
      {"energy_j", "J", "kinetic energy of the passages of these blocks", &PassedSoFar::energy},
      {"file", "", "number of the results file",
       [](const Row& row) { return row->realisation.file + 1; }}};
  return columns;
}

std::vector<PassedSoFar> passage_curve_rows(const ComparisonAnalyses& analyses) {
  std::vector<PassedSoFar> rows;
  for (const RealisationCrossings& realisation : analyses.barrier_crossings()) {
    PassedSoFar sum{realisation, {}};
    for (const BlockCrossing& passage : realisation.passages) {
      rows.push_back({realisation, passage, sum.passed += 1, sum.mass += passage.mass,
                      sum.volume += passage.volume, sum.energy += passage.energy});
    }
  }
  return rows;
}

}  // namespace

std::vector<ComparisonTable> report_detail::make_crossing_tables() {
  return {
      make_comparison_table("passages", passage_columns(), &ComparisonAnalyses::barrier_crossings),
      make_comparison_table("passage_curves", passage_curve_columns(), passage_curve_rows)};
}

}  // namespace clast
