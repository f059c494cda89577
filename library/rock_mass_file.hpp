#pragma once
/// Blocks of a jointed rock mass given as a mesh file.
#include <filesystem>
#include <string>

#include "library/rock_mass_blocks.hpp"

namespace clast {

/// Mesh file of a rock mass, with options for reading it.
struct RockMassFile {
  std::filesystem::path path;
  std::string units = "m";  ///< length unit (see `parse_length_unit`)
  std::string up =
      "auto";  ///< up axis: "z", "y", or "auto", which is y for glTF and z for other formats
};

/// Reads and cuts a rock mass.
/// @throws GeometryError, InputError  if `read_mesh` or `cut_rock_mass` throws; names the file
RockMassBlocks cut_rock_mass_file(const RockMassFile& file, const RockMassOptions& options);

}  // namespace clast
