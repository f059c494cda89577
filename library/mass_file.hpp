#pragma once
/// From the file of a rock mass to the blocks it consists of.
#include <filesystem>
#include <string>

#include "library/mass_blocks.hpp"

namespace clast {

/// A closed mesh of a rock mass, such as a scar, and how to read it.
struct MassFile {
  std::filesystem::path path;
  std::string units = "m";  ///< of length, as `length_unit` reads it
  std::string up =
      "auto";  ///< axis that points up: "z", "y", or "auto", y of glTF, z of all others
};

/// @throws GeometryError, InputError  as `read_mesh` and `blocks_of_mass`, with the file's name
MassBlocks blocks_of_mass_file(const MassFile& file, const MassBlockOptions& options);

}  // namespace clast
