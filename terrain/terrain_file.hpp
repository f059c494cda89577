#pragma once
/// Terrain files (HDF5; schema: docs/formats.md) and exports.
#include <filesystem>
#include <string>

#include "core/files/output_file.hpp"
#include "terrain/terrain.hpp"

namespace clast {

inline constexpr const char* kTerrainFormat = "clast terrain";

/// Writes a terrain file.
/// @throws InputError  as `OutputFile`
void write_terrain(const std::filesystem::path& path, const Terrain& terrain,
                   const OverwritePolicy& rules = {.kind = kTerrainFormat});
/// Reads a terrain file.
/// @throws InputError  if it is missing, not a terrain, damaged, or of a newer schema
Terrain read_terrain_file(const std::filesystem::path& path);

/// Exports the surface by extension: .ply, .obj, .vtp in map coordinates (double); .stl and .glb
/// (floats) in map coordinates minus the local origin, stated in "<path>.origin.txt" if not zero;
/// .tif, the highest surface at the centres of square cells, as GeoTIFF with the coordinate system.
/// @param up  "z"; "y", which rotates (x, y, z) to (x, z, -y); or "auto", y for .glb and z for
///            others; rasters are z up
/// @param cell  of .tif, m
/// @throws InputError  if the extension or axis is unknown, the cell is not positive or far too
///                     small; or as `OutputFile`
void export_terrain(const std::filesystem::path& path, const Terrain& terrain,
                    const std::string& up, double cell = 0.5, const OverwritePolicy& rules = {});

}  // namespace clast
