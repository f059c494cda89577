#pragma once
/// The tables of `clast compare`; columns in docs/formats.md.
#include <vector>

#include "report/tables/report_table.hpp"
#include "study/compare/comparison_analyses.hpp"

namespace clast {

using ComparisonTable = ReportTable<ComparisonAnalyses>;

/// "runs", "barriers", "crossings", ...; "measured" has rows where stops were measured.
const std::vector<ComparisonTable>& comparison_tables();

}  // namespace clast
