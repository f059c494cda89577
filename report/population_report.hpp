#pragma once
/// Report folder of one or two block populations: tables, diagrams and one HTML page.
#include <filesystem>

#include "core/files/output_folder.hpp"
#include "report/reported_population.hpp"

namespace clast {

/// Returns the folder kind by which folders of `write_population_report` are recognised. It
/// includes the diagrams listed in provenance.json of `folder`.
OutputFolderKind population_folder_kind(const std::filesystem::path& folder);

/// Writes classes.csv, shares.csv, sizes.csv, tests.csv, provenance.json, SVG diagrams and a
/// self-contained report.html.
/// @throws InputError  if the folder cannot be created or written
void write_population_report(const PopulationReport& report, const std::filesystem::path& folder);

}  // namespace clast
