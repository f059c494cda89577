#pragma once
/// A mesh made into a grid.
#include <filesystem>

#include "terrain/raw_surface.hpp"
#include "terrain/terrain.hpp"

namespace clast::terrain_detail {

/// Heights of a mesh over the centres of square cells on multiples of `cell`, joined as a raster's
/// are. A new triangle has the source that covers most of its plan area. Cells without ground under
/// their centre stay empty, so that the border moves in by up to a cell. What that leaves out, and
/// the largest change at a vertex of the mesh, is noted.
/// @param surface  oriented
/// @param path     for messages
/// @throws GeometryError  a wall or an overhang larger than a cell, with its place: a grid has one
///                        height over a place
/// @throws InputError     too many cells, or no four neighbouring ones with ground
RawSurface resample_surface(const RawSurface& surface, double cell, const std::filesystem::path& path,
                     TerrainReport& report);

/// The same of the highest of its triangles over every centre, walls and overhangs or not.
/// @throws InputError  as above
TriangleMesh grid_highest_surface(const TriangleMesh& mesh, double cell, const std::filesystem::path& path);

}  // namespace clast::terrain_detail
