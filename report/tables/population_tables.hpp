#pragma once
/// Tables of a block population; columns in docs/formats.md.
#include <filesystem>
#include <string>
#include <vector>

#include "report/reported_population.hpp"
#include "report/tables/report_table.hpp"

namespace clast {

/// Returns the column name of a scheme's class: "shape" for garcia, otherwise the scheme's name
/// with _ for -.
std::string class_column_name(const std::string& scheme);

using PopulationTable = ReportTable<PopulationReport>;

/// Returns the tables "classes", "shares", "sizes" and "tests".
const std::vector<PopulationTable>& population_tables();

/// Writes the table "classes": one row per block with all classes and indices. Rows are made in
/// parallel and written in order; the file does not depend on the number of threads and is never in
/// memory as a whole.
/// @throws InputError  if it cannot be written
void write_classes_csv(const PopulationReport& report, const std::filesystem::path& path,
                       unsigned threads = 0);

}  // namespace clast
