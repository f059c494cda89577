#pragma once
/// Blocks of a rock mass that is given by the terrains before and after its release.
#include <filesystem>
#include <optional>

#include "library/rock_mass_blocks.hpp"
#include "terrain/released_mass.hpp"
#include "terrain/terrain_input.hpp"

namespace clast {

/// Terrain files before and after the release of a rock mass.
struct BeforeAfterTerrains {
  std::vector<std::filesystem::path> before, after;
  std::string up = "auto";  ///< up axis of both terrains, as in `TerrainOptions`
};

/// Reads both terrains and computes the released rock mass between them.
/// @throws InputError, GeometryError  if `read_terrain` or `find_released_mass` throws
ReleasedMass read_released_mass(const BeforeAfterTerrains& terrains,
                                const ReleasedMassOptions& options);

/// Cuts each body of a released rock mass by joints. The blocks are in map coordinates.
/// @throws InputError, GeometryError  if `cut_rock_masses` throws
RockMassBlocks cut_released_mass(const ReleasedMass& mass, const BeforeAfterTerrains& terrains,
                                 const ReleasedMassOptions& options,
                                 const RockMassOptions& cutting);

/// Returns the bodies of a released rock mass as one mesh in map coordinates.
TriangleMesh make_released_mass_mesh(const ReleasedMass& mass);

}  // namespace clast
