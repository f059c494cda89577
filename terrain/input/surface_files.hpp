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
  kTerrain  ///< a terrain file, checked and repaired already
};

/// Detects the common kind of the files by their extensions.
/// @throws InputError  if an extension is unknown, kinds are mixed, or there are several rasters or
///                     terrain files
SurfaceKind detect_surface_kind(const std::vector<std::filesystem::path>& files);

/// Reads meshes, a raster or clouds, z up. Rasters are coarsened and clouds gridded as the options
/// state, and holes of both are filled; nothing else is repaired.
/// @param kind  not `kTerrain`
/// @throws InputError  if a file cannot be read, heights are invalid, or the resolution is finer
///                     than the raster
RawSurface read_surface(const TerrainOptions& options, SurfaceKind kind);

}  // namespace clast::terrain_detail
