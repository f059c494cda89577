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
/// @throws InputError  if the file is missing, damaged, not a terrain or of a newer schema
Terrain read_terrain_file(const std::filesystem::path& path);

/// Exports the surface. The extension of `path` selects the format:
/// - .ply, .obj, .vtp: map coordinates in double precision.
/// - .stl, .glb: local coordinates in single precision. If the local origin is not zero, it is
///   written to "<path>.origin.txt".
/// - .tif: GeoTIFF of the highest surface at the centres of square cells.
/// @param up  up axis: "z"; "y", which rotates (x, y, z) to (x, z, -y); or "auto", which is y for
///            .glb and z for others. Rasters are always z up
/// @param cell  cell size of a .tif, m
/// @throws InputError  if the extension or axis is unknown, or if the cell is not positive or far
///                     too small; or as `OutputFile`
void export_terrain(const std::filesystem::path& path, const Terrain& terrain,
                    const std::string& up, double cell = 0.5, const OverwritePolicy& rules = {});

}  // namespace clast
