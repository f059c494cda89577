#pragma once
/// The tables of a population of blocks; columns in docs/formats.md.
#include <filesystem>
#include <string>
#include <vector>

#include "report/reported_population.hpp"
#include "report/tables/report_table.hpp"

namespace clast {

/// Column that holds the class of a scheme: "shape" for garcia, as everywhere; else the scheme's
/// name with _ for -.
std::string class_column_name(const std::string& scheme);

using PopulationTable = ReportTable<PopulationReport>;

/// "classes", "shares", "sizes", "tests".
const std::vector<PopulationTable>& population_tables();

/// The file of "classes": a row per block with all classes and indices. Rows are made in parallel
/// and written in order, so the file is the same for any number of threads and never whole in
/// memory.
/// @throws InputError  can't be written
void write_classes_csv(const PopulationReport& report, const std::filesystem::path& path,
                       unsigned threads = 0);

}  // namespace clast
