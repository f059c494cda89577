#pragma once
/// Scans named on a command line, and the ids of their blocks.
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "shapes/shp_file.hpp"

namespace clast {

/// Scan file, folder of photographs, or one shape of a .shp file, with the id of its block.
struct ScanFile {
  std::filesystem::path path;
  std::string id;
  std::optional<ShpShape> shape;
  std::vector<std::filesystem::path> others = {};  ///< further scans that are joined to it

  bool is_shp() const;
  /// Returns the paths of all scans of the block.
  std::vector<std::filesystem::path> paths() const;
};

/// Lists the scans of files and folders, sorted by path and without duplicates. Folders are
/// searched for mesh and shape files (not ESRI shapefiles), recursively except in hidden folders. A
/// folder of photographs without such files is one scan, and so is each folder of photographs in a
/// folder without files. The id is the file stem, the name of a folder of photographs (of its
/// parent for names such as "images"), or the shape name if a .shp file has several shapes. If ids
/// are equal, the name of the parent folder is added, and then the extension.
/// @throws InputError  if a folder has no scan or cannot be searched, or if ids are still equal
std::vector<ScanFile> list_scans(const std::vector<std::string>& inputs);

/// Makes one entry of several scans of a block, in the given order.
/// @param inputs  files and folders of photographs
/// @throws InputError  if there are fewer than two or more than eight scans, or one is a shape or
///                     given twice
ScanFile list_joined_scans(const std::vector<std::string>& inputs, const std::string& id);

/// Makes one entry of the scans of each folder, with the name of the folder as its id. A folder
/// with a single scan is a block of that scan.
/// @throws InputError  if `list_scans` or `list_joined_scans` would throw
std::vector<ScanFile> list_joined_folders(const std::vector<std::string>& folders);

}  // namespace clast
