#pragma once
/// Blocks of a rock mass given by terrains before and after its fall.
#include <filesystem>
#include <optional>

#include "library/rock_mass_blocks.hpp"
#include "terrain/released_mass.hpp"
#include "terrain/terrain_input.hpp"

namespace clast {

/// Terrain files before and after, as `read_terrain` accepts.
struct BeforeAfterTerrains {
  std::vector<std::filesystem::path> before, after;
  std::string up = "auto";  ///< of both, as in TerrainOptions
};

/// Reads both terrains and computes the released mass.
/// @throws InputError, GeometryError  as `read_terrain` and `find_released_mass`
ReleasedMass read_released_mass(const BeforeAfterTerrains& terrains,
                                const ReleasedMassOptions& options);

/// Cuts each body of the mass by joints. Blocks are in map coordinates, as `[[mass]] in_place`
/// expects; their source names both terrains and the options.
/// @throws InputError, GeometryError  as `cut_rock_masses`
RockMassBlocks cut_released_mass(const ReleasedMass& mass, const BeforeAfterTerrains& terrains,
                                 const ReleasedMassOptions& options,
                                 const RockMassOptions& cutting);

/// Returns the bodies of the mass as one mesh in map coordinates.
TriangleMesh make_mass_mesh(const ReleasedMass& mass);

}  // namespace clast
