#pragma once
/// Detection of file kinds, so that no output replaces a file of another kind.
#include <filesystem>
#include <string>

namespace clast {

/// File kind of campaigns, which are TOML files with certain tables.
inline constexpr const char* kCampaignKind = "campaign";

/// File kind of HTML pages written by clast.
inline constexpr const char* kPageKind = "page of clast";

/// Detects the kind of a file by its content; empty if the file is missing or empty. For an HDF5
/// file written by clast, the kind is its format ("clast terrain"). Other kinds are "HDF5", "PNG",
/// "SVG", `kPageKind`, "HTML", "TIFF", "SQLite" (GeoPackages), "glTF", "PLY", "STL", "VTK", "origin
/// of coordinates" (beside a mesh), `kCampaignKind`, "text" and "binary".
std::string detect_file_kind(const std::filesystem::path& path);

/// Returns the kind of the files that clast writes with the extension of `path`, such as "PNG" for
/// .png. It is "text" for extensions without a kind, including .h5.
std::string file_kind_by_extension(const std::filesystem::path& path);

}  // namespace clast
