#pragma once
/// The folder of files about a comparison: tables, map layers and one HTML page.
#include <filesystem>
#include <vector>

#include "core/output_folder.hpp"
#include "study/comparison.hpp"

namespace clast {

/// How a folder is known that `write_comparison` and `write_animation` filled.
FolderKind comparison_folder();

/// Writes the tables, provenance.json, stops.gpkg and rasters/ (map layers) and report.html to
/// `folder`.
/// @return what was written, the report last
/// @throws InputError  the folder can't be made or written to
std::vector<std::filesystem::path> write_comparison(const Comparison& comparison,
                                                    const std::filesystem::path& folder);

}  // namespace clast
