#pragma once
/// The columns of the rows of a results file, as columns of tables.
#include <cmath>
#include <string_view>

#include "core/files/table.hpp"
#include "study/results/results.hpp"

namespace clast {

/// Named and described as in docs/formats.md; positions are in the terrain's local frame.
const TableColumns<RunRecord>& stored_run_columns();
const TableColumns<Crossing>& stored_crossing_columns();
const TableColumns<Impact>& stored_impact_columns();
const TableColumns<PersistentBlockRecord>& stored_stay_columns();
const TableColumns<EnergyRecord>& stored_energy_columns();

/// Columns of runs and stays that take contacts to know, which other engines do not tell: results
/// of these are without them, and their cells are empty.
bool is_of_contacts(std::string_view column);

/// The same columns, with empty cells for what is not known of a row.
/// @param results_of  the results that a row is of
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
