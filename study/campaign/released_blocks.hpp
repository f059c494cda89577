#pragma once
/// Blocks of a rock mass that is given by the terrains before and after its fall.
#include <filesystem>
#include <optional>

#include "library/rock_mass_blocks.hpp"
#include "terrain/released_mass.hpp"
#include "terrain/terrain_input.hpp"

namespace clast {

/// Terrain files before and after, as `read_terrain` accepts.
struct BeforeAfterTerrains {
  std::vector<std::filesystem::path> before, after;
  std::string up = "auto";  ///< up axis of both, as in TerrainOptions
};

/// Reads both terrains and computes the released mass.
/// @throws InputError, GeometryError  if `read_terrain` or `find_released_mass` throws
ReleasedMass read_released_mass(const BeforeAfterTerrains& terrains,
                                const ReleasedMassOptions& options);

/// Cuts each body of the mass by joints. Blocks are in map coordinates, as required by `[[mass]]
/// in_place`. Their source states both terrains and the options.
/// @throws InputError, GeometryError  if `cut_rock_masses` throws
RockMassBlocks cut_released_mass(const ReleasedMass& mass, const BeforeAfterTerrains& terrains,
                                 const ReleasedMassOptions& options,
                                 const RockMassOptions& cutting);

/// Returns the bodies of the mass as one mesh in map coordinates.
TriangleMesh make_released_mass_mesh(const ReleasedMass& mass);

}  // namespace clast
