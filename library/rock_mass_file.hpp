#pragma once
/// From the file of a rock mass to the blocks it consists of.
#include <filesystem>
#include <string>

#include "library/rock_mass_blocks.hpp"

namespace clast {

/// A closed mesh of a rock mass, such as a scar, and how to read it.
struct RockMassFile {
  std::filesystem::path path;
  std::string units = "m";  ///< of length, as `parse_length_unit` reads it
  std::string up =
      "auto";  ///< axis that points up: "z", "y", or "auto", y of glTF, z of all others
};

/// @throws GeometryError, InputError  as `read_mesh` and `cut_rock_mass`, with the file's name
RockMassBlocks cut_rock_mass_file(const RockMassFile& file, const RockMassOptions& options);

}  // namespace clast
