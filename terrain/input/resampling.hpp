#pragma once
/// Resampling of meshes to grids.
#include <filesystem>

#include "terrain/raw_surface.hpp"
#include "terrain/terrain.hpp"

namespace clast::terrain_detail {

/// Resamples a mesh at the centres of square cells on multiples of `cell` and triangulates them
/// like a raster. A new triangle gets the source file that covers most of its plan area. Cells
/// without ground at their centre stay empty, so that the border recedes by up to a cell. The
/// omitted area and the largest height change at a vertex are noted.
/// @param surface  consistently oriented mesh
/// @param path  file name for messages
/// @throws GeometryError  if a wall or overhang is larger than a cell; the message gives its
///                        position
/// @throws InputError  if there are too many cells, or if no four adjacent cells have ground
RawSurface resample_surface(const RawSurface& surface, double cell,
                            const std::filesystem::path& path, TerrainReport& report);

/// Resamples the highest triangle over each cell centre. Walls and overhangs are allowed.
/// @throws InputError  as above
TriangleMesh grid_highest_surface(const TriangleMesh& mesh, double cell,
                                  const std::filesystem::path& path);

}  // namespace clast::terrain_detail
