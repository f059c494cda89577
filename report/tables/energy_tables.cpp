// The table of where the energy of blocks that stay goes.
#include "report/tables/comparison_columns.hpp"
#include "study/results/stored_columns.hpp"

namespace clast {

using namespace report_detail;
namespace {

/// The energy of a realisation at one instant.
struct EnergyOfFile {
  std::uint32_t file = 0;
  std::uint32_t realisation = 0;  ///< from 0
  const EnergyRecord& record;
};

const TableColumns<EnergyOfFile>& energy_columns() {
  using Row = EnergyOfFile;
  static const auto columns = concatenated_columns<Row>(
      {{{"realisation", "", "number of the realisation, from 1",
         [](const Row& row) { return row.realisation + 1; }}},
       adapt_columns<Row>(
           selected_columns(
               stored_energy_columns(),
               {"time_s", "moving", "translational_j", "rotational_j", "potential_j", "stored_j",
                "gone_j", "ground_normal_j", "ground_friction_j", "ground_rolling_j",
                "blocks_normal_j", "blocks_friction_j", "blocks_rolling_j", "reassigned_j"}),
           [](const Row& row) -> const EnergyRecord& { return row.record; }),
       {{"file", "", "number of the results file", [](const Row& row) { return row.file + 1; }}}});
  return columns;
}

std::vector<EnergyOfFile> energy_rows(const Comparison& comparison) {
  std::vector<EnergyOfFile> rows;
  for (std::uint32_t file = 0; file < comparison.results.size(); ++file) {
    const CampaignResults& results = comparison.results[file];
    for (const EnergyRecord& record : results.energies) {
      rows.push_back({file, record.run / results.runs_per_realisation(), record});
    }
  }
  return rows;
}

}  // namespace

std::vector<ComparisonTable> report_detail::make_energy_tables() {
  return {make_comparison_table("energies", energy_columns(), energy_rows)};
}

}  // namespace clast
