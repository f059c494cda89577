#pragma once
/// The folder of files about a comparison: tables, map layers and one HTML page.
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/files/output_folder.hpp"
#include "study/compare/comparison_analyses.hpp"

namespace clast {

/// How a folder is known that `write_comparison` and `write_animation` filled.
FolderKind comparison_folder_kind();

/// Writes the tables, provenance.json, stops.gpkg and rasters/ (map layers) and report.html to
/// `folder`.
/// @return what was written, the report last
/// @throws InputError  the folder can't be made or written to
std::vector<std::filesystem::path> write_comparison(const ComparisonAnalyses& analyses,
                                                    const std::filesystem::path& folder);

/// What a folder is to hold besides tables, map layers and page.
struct ComparisonReportOptions {
  std::size_t animated = 0;            ///< runs of animation/animation.pvd; 0: there is none
  std::filesystem::path browser = {};  ///< that prints report.pdf; empty: there is none
};

struct WrittenReport {
  std::vector<std::filesystem::path> files;  ///< relative to it, the report last
  std::optional<std::string> no_pdf;         ///< why the report could not be printed
};

/// `write_comparison` with extras, then `OutputFolder::commit`.
/// @throws InputError  as both; no trajectory to animate
WrittenReport fill_folder(OutputFolder& folder, const ComparisonAnalyses& analyses,
                         const ComparisonReportOptions& extras = {});

}  // namespace clast
