#pragma once
/// Report folder of a comparison: tables, map layers and one HTML page.
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/files/output_folder.hpp"
#include "study/compare/comparison_analyses.hpp"

namespace clast {

/// Returns the folder kind of comparison reports, which identifies folders written by
/// `write_comparison`.
OutputFolderKind comparison_folder_kind();

/// Writes the report of a comparison to a folder: tables, map layers, provenance and page.
/// @return the written files, the report last
/// @throws InputError  if the folder cannot be created or written
std::vector<std::filesystem::path> write_comparison(const ComparisonAnalyses& analyses,
                                                    const std::filesystem::path& folder);

/// Optional contents of a report folder.
struct ComparisonReportOptions {
  std::size_t animated_runs = 0;  ///< number of animated runs; if 0, no animation is written
  /// Browser that prints report.pdf; if empty, no PDF is written.
  std::filesystem::path browser = {};
};

struct WrittenReport {
  /// Written files, relative to the folder, the report last.
  std::vector<std::filesystem::path> files;
  std::optional<std::string> pdf_failure;  ///< reason why the PDF could not be printed
};

/// Writes the report of a comparison with its optional contents, and moves the folder to its final
/// path.
/// @throws InputError  if `write_comparison` or `OutputFolder::commit` throws, or if there is no
///                     trajectory to animate
WrittenReport write_report_folder(OutputFolder& folder, const ComparisonAnalyses& analyses,
                                  const ComparisonReportOptions& extras = {});

}  // namespace clast
