#pragma once
/// Blocks of a jointed rock mass given as a mesh file.
#include <filesystem>
#include <string>

#include "library/rock_mass_blocks.hpp"

namespace clast {

/// Mesh file of a rock mass, such as a scar, and how to read it.
struct RockMassFile {
  std::filesystem::path path;
  std::string units = "m";  ///< length unit, as in `parse_length_unit`
  std::string up =
      "auto";  ///< axis that points up: "z", "y", or "auto", y of glTF, z of all others
};

/// Reads and cuts a rock mass.
/// @throws GeometryError, InputError  as `read_mesh` and `cut_rock_mass`, with the file's name
RockMassBlocks cut_rock_mass_file(const RockMassFile& file, const RockMassOptions& options);

}  // namespace clast
