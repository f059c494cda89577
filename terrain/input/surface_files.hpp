#pragma once
/// The files that a ground is read from.
#include <filesystem>
#include <vector>

#include "terrain/raw_surface.hpp"
#include "terrain/terrain_input.hpp"

namespace clast::terrain_detail {

enum class SurfaceKind {
  kMesh,
  kRaster,
  kCloud,
  kTerrain  ///< a terrain file, checked and repaired already
};

/// What kind all of them are, by their extensions.
/// @throws InputError  an extension that is none of them, kinds that are mixed, or several rasters
///                     or terrain files
SurfaceKind detect_surface_kind(const std::vector<std::filesystem::path>& files);

/// Reads meshes, a raster or clouds, z up. Rasters get coarser and clouds become a grid as the
/// options say, and holes of both are filled; nothing else is repaired.
/// @param kind  not `kTerrain`
/// @throws InputError  a file that can't be read, heights that are none, or a resolution finer than
///                     the raster
RawSurface read_surface(const TerrainOptions& options, SurfaceKind kind);

}  // namespace clast::terrain_detail
