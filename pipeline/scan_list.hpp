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

  bool is_shp() const;
};

/// Lists scans: files, and all mesh and shape files in folders (without ESRI shapefiles),
/// recursively except in hidden folders, sorted by path and without duplicates. A folder with
/// photographs and no such file is one block, as is each folder of photographs in a folder without
/// any. The id is the file stem, the name of a folder of photographs (of its parent for names such
/// as "images"), or the shape name if a .shp file has several. If ids are equal, the parent folder
/// is added; if these are equal, too, the extension is, as for one scan in two formats.
/// @throws InputError  if a folder has no scan or cannot be searched, or files share all of that
std::vector<ScanFile> list_scans(const std::vector<std::string>& inputs);

}  // namespace clast
