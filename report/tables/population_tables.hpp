#pragma once
/// Tables of a block population. docs/formats.md lists their columns.
#include <filesystem>
#include <string>
#include <vector>

#include "report/reported_population.hpp"
#include "report/tables/report_table.hpp"

namespace clast {

/// Returns the name of the table column with the classes of a scheme.
std::string class_column_name(const std::string& scheme);

using PopulationTable = ReportTable<PopulationReport>;

/// Returns the tables of a population report: "classes", "shares", "sizes" and "tests", and those
/// of scanned deposits (`scanned_deposit_tables`).
const std::vector<PopulationTable>& population_tables();

/// Writes the table "classes" as CSV file: one row per block with all classes and indices. The file
/// does not depend on the number of threads.
/// @throws InputError  if the file cannot be written
void write_classes_csv(const PopulationReport& report, const std::filesystem::path& path,
                       unsigned threads = 0);

}  // namespace clast
