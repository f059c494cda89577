#pragma once
/// Tables of `clast compare`; columns in docs/formats.md.
#include <vector>

#include "report/tables/report_table.hpp"
#include "study/compare/comparison_analyses.hpp"

namespace clast {

using ComparisonTable = ReportTable<ComparisonAnalyses>;

/// Returns all tables: "runs", "barriers", "crossings", ...; "measured" is empty without observed
/// stops.
const std::vector<ComparisonTable>& comparison_tables();

}  // namespace clast
