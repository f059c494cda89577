#pragma once
/// Tables of a comparison. docs/formats.md lists their columns.
#include <vector>

#include "report/tables/report_table.hpp"
#include "study/compare/comparison_analyses.hpp"

namespace clast {

using ComparisonTable = ReportTable<ComparisonAnalyses>;

/// Returns all tables, such as "runs" and "crossings". "measured" is empty without observed stops.
const std::vector<ComparisonTable>& comparison_tables();

}  // namespace clast
