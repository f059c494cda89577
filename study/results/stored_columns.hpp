#pragma once
/// Columns of the datasets of a results file.
#include <cmath>
#include <string_view>

#include "core/files/table.hpp"
#include "study/results/results.hpp"

namespace clast {

/// Columns with names and descriptions as in docs/formats.md; positions in the terrain's local
/// frame.
const TableColumns<RunRecord>& stored_run_columns();
const TableColumns<Crossing>& stored_crossing_columns();
const TableColumns<Impact>& stored_impact_columns();
const TableColumns<PersistentBlockRecord>& stored_persistent_block_columns();
const TableColumns<EnergyRecord>& stored_energy_columns();

/// True if a column depends on contact data, which other engines do not provide: its datasets are
/// then missing and its cells empty.
bool is_of_contacts(std::string_view column);

/// Returns the columns with empty cells for unknown contact data.
/// @param results_of  returns the results that contain a row
template <class Row, class ResultsOf>
TableColumns<Row> blank_unknown_cells(TableColumns<Row> columns, const ResultsOf& results_of) {
  for (TableColumn<Row>& column : columns) {
    if (!is_of_contacts(column.name)) continue;
    column.value = [results_of, value = column.value](const Row& row) -> TableCell {
      return results_of(row).has_contacts() ? value(row) : TableCell(std::nan(""));
    };
  }
  return columns;
}

}  // namespace clast
