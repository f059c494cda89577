#pragma once
/// Detection of file kinds, so that no output replaces a file of another kind.
#include <filesystem>
#include <string>

namespace clast {

/// Kind of TOML files with the tables of a campaign.
inline constexpr const char* kCampaignKind = "campaign";

/// Kind of HTML pages written by clast.
inline constexpr const char* kPageKind = "page of clast";

/// Detects the kind of a file by its content: the format of an HDF5 file written by clast ("clast
/// terrain"), otherwise "HDF5", "PNG", "SVG", `kPageKind` or "HTML", "TIFF", "SQLite"
/// (GeoPackages), "glTF", "PLY", "STL", "VTK", "origin of coordinates" (beside a mesh),
/// `kCampaignKind`, "text" or "binary". Empty if the file is missing or empty.
std::string detect_file_kind(const std::filesystem::path& path);

/// Returns the kind that clast writes under a file name, by its extension, as in
/// `detect_file_kind`. HDF5 files are identified by format only.
std::string file_kind_by_extension(const std::filesystem::path& path);

}  // namespace clast
