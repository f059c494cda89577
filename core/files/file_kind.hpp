#pragma once
/// The kind of a file, so that no output replaces something else.
#include <filesystem>
#include <string>

namespace clast {

/// Of TOML files with the tables that every campaign has.
inline constexpr const char* kCampaignKind = "campaign";

/// Of HTML pages that clast wrote.
inline constexpr const char* kPageKind = "page of clast";

/// What the file is by its content: the format of an HDF5 file that clast wrote ("clast terrain"),
/// else "HDF5", "PNG", "SVG", `kPageKind` or "HTML", "TIFF", "SQLite" (GeoPackages), "glTF", "PLY",
/// "STL", "VTK", "origin of coordinates" (beside a mesh), `kCampaignKind`, "text" or "binary".
/// Empty when there is no such file, or nothing in it.
std::string detect_file_kind(const std::filesystem::path& path);

/// What a file of this name is when clast writes it, by the extension and in the words of
/// `detect_file_kind`. HDF5 files are named by their format alone.
std::string file_kind_by_extension(const std::filesystem::path& path);

}  // namespace clast
