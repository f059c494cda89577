#pragma once
/// The HDF5 terrain file (schema: docs/formats.md) and exports for other tools.
#include <filesystem>

#include "terrain/terrain.hpp"

namespace clast {

void write_terrain(const std::filesystem::path& path, const Terrain& terrain);
/// @throws InputError  missing, not a clast terrain, damaged, or of a newer schema
Terrain read_terrain_file(const std::filesystem::path& path);

/// Writes the surface for viewing, by extension: .stl, .ply, .obj, .vtp (vertices in map coordinates
/// less a whole-number origin that the note says), or .tif (heights as GeoTIFF, needs `cell`, m).
/// @param up  "z", or "y" to turn back
void export_terrain(const std::filesystem::path& path, const Terrain& terrain, const std::string& up,
                    double cell = 0.5);

}  // namespace clast
