#pragma once
/// From the terrains before and after to the blocks of the mass that came down between them.
#include <filesystem>
#include <optional>

#include "library/rock_mass_blocks.hpp"
#include "terrain/released_mass.hpp"
#include "terrain/terrain_input.hpp"

namespace clast {

/// The files of both surfaces, as `read_terrain` takes them.
struct MassTerrains {
  std::vector<std::filesystem::path> before, after;
  std::string up = "auto";  ///< of both, as in TerrainOptions
};

/// @throws InputError, GeometryError  as `read_terrain` and `find_released_mass`
ReleasedMass read_released_mass(const MassTerrains& terrains, const ReleasedMassOptions& options);

/// Cuts every body of the mass by joints, in map coordinates as `[[mass]] in_place` has them.
/// Blocks name both terrains and what was asked of them as their source.
/// @throws InputError, GeometryError  as `distribute_blocks`
RockMassBlocks blocks_of_released_mass(const ReleasedMass& mass, const MassTerrains& terrains,
                                       const ReleasedMassOptions& options,
                                       const RockMassOptions& cutting);

/// The bodies of the mass as one mesh, on the map.
TriangleMesh mesh_of(const ReleasedMass& mass);

}  // namespace clast
