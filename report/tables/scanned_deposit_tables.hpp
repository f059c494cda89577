#pragma once
/// Tables of the populations of scanned deposits. docs/formats.md lists their columns.
#include <vector>

#include "report/tables/population_tables.hpp"

namespace clast {

/// Returns the tables "scanned_blocks", "scanned_shares" and "scanned_sizes". They have no rows if
/// there is no scanned deposit.
const std::vector<PopulationTable>& scanned_deposit_tables();

}  // namespace clast
