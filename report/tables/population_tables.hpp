#pragma once
/// The tables of a population of blocks; columns in docs/formats.md.
#include <filesystem>
#include <string>
#include <vector>

#include "report/reported_population.hpp"

namespace clast {

/// Column that holds the class of a scheme: "shape" for garcia, as everywhere; else the scheme's
/// name with _ for -.
std::string class_column(const std::string& scheme);

/// shares.csv, sizes.csv and tests.csv as text.
std::string shares_csv(const PopulationReport& report);
std::string sizes_csv(const PopulationReport& report);
std::string tests_csv(const PopulationReport& report);

/// classes.csv: a row per block with all classes and indices. Rows are made in parallel and written
/// in order, so the file is the same for any number of threads and never whole in memory.
/// @throws InputError  can't be written
void write_classes_csv(const PopulationReport& report, const std::filesystem::path& path,
                       unsigned threads = 0);

}  // namespace clast
