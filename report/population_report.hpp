#pragma once
/// Report folder of one or two block populations: tables, diagrams and one HTML page.
#include <filesystem>

#include "core/files/output_folder.hpp"
#include "report/reported_population.hpp"

namespace clast {

/// Returns the folder kind of population reports, which identifies folders written by
/// `write_population_report`.
OutputFolderKind population_folder_kind(const std::filesystem::path& folder);

/// Writes the report of one or two populations to a folder: tables, diagrams, provenance and page.
/// @throws InputError  if the folder cannot be created or written
void write_population_report(const PopulationReport& report, const std::filesystem::path& folder);

}  // namespace clast
