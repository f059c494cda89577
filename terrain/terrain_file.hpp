#pragma once
/// The HDF5 terrain file (schema: docs/formats.md) and exports for other tools.
#include <filesystem>
#include <string>

#include "core/files/output_file.hpp"
#include "terrain/terrain.hpp"

namespace clast {

/// The format name in a terrain file.
inline constexpr const char* kTerrainFormat = "clast terrain";

/// @throws InputError  as `OutputFile`
void write_terrain(const std::filesystem::path& path, const Terrain& terrain,
                   const OverwritePolicy& rules = {.kind = kTerrainFormat});
/// @throws InputError  missing, not a clast terrain, damaged, or of a newer schema
Terrain read_terrain_file(const std::filesystem::path& path);

/// Writes the surface for other tools, by extension: .ply, .obj, .vtp in map coordinates (double);
/// .stl and .glb, which hold floats, in map coordinates less the local origin, with a file
/// "<path>.origin.txt" that says so when that is not zero; .tif, the highest surface at the centres
/// of square cells as GeoTIFF with the coordinate system.
/// @param up    "z"; "y" to turn (x, y, z) to (x, z, -y); or "auto", y in .glb, as its standard has
///              it, and z in all others; rasters are z up
/// @param cell  of .tif, m
/// @throws InputError  unknown extension or axis, a cell that is not positive or far too small, or
///                     as `OutputFile`
void export_terrain(const std::filesystem::path& path, const Terrain& terrain,
                    const std::string& up, double cell = 0.5, const OverwritePolicy& rules = {});

}  // namespace clast
