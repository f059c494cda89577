#pragma once
/// Columns of the datasets of a results file.
#include <cmath>
#include <string_view>

#include "core/files/table.hpp"
#include "study/results/results.hpp"

namespace clast {

/// Returns the columns of the dataset of runs, with names, units and descriptions.
const TableColumns<RunRecord>& stored_run_columns();
const TableColumns<Crossing>& stored_crossing_columns();
const TableColumns<Impact>& stored_impact_columns();
const TableColumns<PersistentBlockRecord>& stored_persistent_block_columns();
const TableColumns<EnergyRecord>& stored_energy_columns();

/// True if a column depends on contact data, which results of other engines do not have.
bool depends_on_contact_data(std::string_view column);

/// Returns columns whose cells are empty where contact data are missing.
/// @param results_of  function that returns the results that contain a row
template <class Row, class ResultsOf>
TableColumns<Row> blank_unknown_cells(TableColumns<Row> columns, const ResultsOf& results_of) {
  for (TableColumn<Row>& column : columns) {
    if (!depends_on_contact_data(column.name)) continue;
    column.value = [results_of, value = column.value](const Row& row) -> TableCell {
      return results_of(row).has_contacts() ? value(row) : TableCell(std::nan(""));
    };
  }
  return columns;
}

}  // namespace clast
