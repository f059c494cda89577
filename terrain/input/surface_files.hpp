#pragma once
/// Reading of the surface files of a terrain.
#include <filesystem>
#include <vector>

#include "terrain/raw_surface.hpp"
#include "terrain/terrain_input.hpp"

namespace clast::terrain_detail {

enum class SurfaceKind {
  kMesh,
  kRaster,
  kCloud,
  kTerrain  ///< terrain file, already checked and repaired
};

/// Detects the common kind of surface files by their extensions.
/// @throws InputError  if an extension is unknown, if kinds are mixed, or if there are several
///                     rasters or terrain files
SurfaceKind detect_surface_kind(const std::vector<std::filesystem::path>& files);

/// Reads meshes, a raster or clouds and rotates them to z up. Rasters are coarsened and clouds
/// gridded as `options` state. Holes in both are filled; nothing else is repaired.
/// @param kind  not `kTerrain`
/// @throws InputError  if a file cannot be read, if heights are invalid, or if the resolution is
///                     finer than the raster
RawSurface read_surface(const TerrainOptions& options, SurfaceKind kind);

}  // namespace clast::terrain_detail
