#pragma once
/// Which scans a command line names, and the ids their blocks get.
#include <filesystem>
#include <string>
#include <vector>

namespace clast {

/// A scan file and the id of its block.
struct ScanFile {
  std::filesystem::path path;
  std::string id;
};

/// Files as they are, folders as every mesh file in them, deeper folders included, sorted by path;
/// a file that is named twice is taken once. The id is the file's stem; where two share a stem,
/// parent folder and stem.
/// @throws InputError  a folder without a mesh file, or files that share folder name and stem
std::vector<ScanFile> list_scans(const std::vector<std::string>& inputs);

}  // namespace clast
