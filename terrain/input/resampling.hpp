#pragma once
/// Resampling of meshes to grids.
#include <filesystem>

#include "terrain/raw_surface.hpp"
#include "terrain/terrain.hpp"

namespace clast::terrain_detail {

/// Resamples a mesh at the centres of square cells on multiples of `cell`, triangulated like a
/// raster. A new triangle has the source with the largest plan area in it. Cells without ground at
/// their centre stay empty, so that the border recedes by up to a cell. The omitted area and the
/// largest change at a vertex are noted.
/// @param surface  oriented
/// @param path  for messages
/// @throws GeometryError  if a wall or overhang is larger than a cell, with its position
/// @throws InputError  if there are too many cells, or no four adjacent cells with ground
RawSurface resample_surface(const RawSurface& surface, double cell,
                            const std::filesystem::path& path, TerrainReport& report);

/// Resamples the highest triangle over each cell centre, allowing walls and overhangs.
/// @throws InputError  as above
TriangleMesh grid_highest_surface(const TriangleMesh& mesh, double cell,
                                  const std::filesystem::path& path);

}  // namespace clast::terrain_detail
