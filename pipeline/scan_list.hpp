#pragma once
/// Which scans a command line names, and the ids their blocks get.
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "shapes/shp_file.hpp"

namespace clast {

/// A scan file, or a folder of photographs, and the id of its block; of a .shp file one of its
/// shapes, none where it can't be read.
struct ScanFile {
  std::filesystem::path path;
  std::string id;
  std::optional<ShpShape> shape;

  bool is_shp() const;
};

/// Files as they are, folders as every mesh and shape file in them (map files of the extension .shp
/// left out), deeper folders included (not those whose names start with a
/// dot), sorted by path; a file that is named twice is taken once. A
/// folder with photographs and no such file is one block, and so is each folder of photographs in
/// one without any.
/// The id is the file's stem, the name of a folder of photographs (of B017/images, where the name
/// only says that there are pictures, that of the folder above), or the name of a shape where a
/// .shp file holds several (of a name that is a path, the stem); where two share an id, parent
/// folder and id; where they share these too, the extension follows: one scan in two formats, or
/// two scans, is for the user to say.
/// @throws InputError  a folder without a scan or that can't be searched, or files that share all
///                     of that
std::vector<ScanFile> list_scans(const std::vector<std::string>& inputs);

}  // namespace clast
