#pragma once
/// Tables of a block population. docs/formats.md lists their columns.
#include <filesystem>
#include <string>
#include <vector>

#include "report/reported_population.hpp"
#include "report/tables/report_table.hpp"

namespace clast {

/// Returns the name of the column with the classes of a scheme. It is "shape" for garcia, otherwise
/// the name of the scheme with _ for -.
std::string class_column_name(const std::string& scheme);

using PopulationTable = ReportTable<PopulationReport>;

/// Returns the tables "classes", "shares", "sizes" and "tests".
const std::vector<PopulationTable>& population_tables();

/// Writes the table "classes", with one row per block that has all classes and indices. Rows are
/// made in parallel and written in order. The file does not depend on the number of threads and is
/// never completely in memory.
/// @throws InputError  if the file cannot be written
void write_classes_csv(const PopulationReport& report, const std::filesystem::path& path,
                       unsigned threads = 0);

}  // namespace clast
