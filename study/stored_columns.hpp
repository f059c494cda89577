#pragma once
/// The columns of the rows of a results file, as columns of tables.
#include "core/table.hpp"
#include "study/results.hpp"

namespace clast {

/// Named and described as in docs/formats.md; positions are in the terrain's local frame.
const TableColumns<RunRecord>& stored_run_columns();
const TableColumns<Crossing>& stored_crossing_columns();
const TableColumns<Impact>& stored_impact_columns();
const TableColumns<StayRecord>& stored_stay_columns();

}  // namespace clast
