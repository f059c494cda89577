#pragma once
/// Tables of a comparison. docs/formats.md lists their columns.
#include <vector>

#include "report/tables/report_table.hpp"
#include "study/compare/comparison_analyses.hpp"

namespace clast {

using ComparisonTable = ReportTable<ComparisonAnalyses>;

/// Returns all tables of a comparison, such as "runs" and "crossings".
const std::vector<ComparisonTable>& comparison_tables();

}  // namespace clast
