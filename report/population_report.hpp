#pragma once
/// The folder of files about a population of blocks, or about two: tables, diagrams and one HTML
/// page.
#include <filesystem>

#include "core/files/output_folder.hpp"
#include "report/reported_population.hpp"

namespace clast {

/// How `folder` is known to be one that `write_population_report` filled, by the diagrams that its
/// provenance.json lists.
FolderKind population_folder_kind(const std::filesystem::path& folder);

/// Writes classes.csv, shares.csv, sizes.csv, tests.csv, provenance.json, the diagrams as .svg and
/// report.html, one page that needs no network, to `folder`.
/// @throws InputError  the folder can't be made or written to
void write_population_report(const PopulationReport& report, const std::filesystem::path& folder);

}  // namespace clast
