#pragma once
/// Repair of raw surfaces for contact: welding, removal of degenerate triangles, upward
/// orientation.
#include <string>
#include <vector>

#include "terrain/raw_surface.hpp"
#include "terrain/terrain.hpp"

namespace clast::terrain_detail {

/// Merges vertices within 1e-6 m. Real terrain has edges under 1 mm, so only duplicates are merged.
void weld_surface(RawSurface& surface, TerrainReport& report);

/// Removes triangles with a repeated vertex or a height below 1e-9 m, duplicate triangles, and
/// unused vertices.
/// @param files  of `RawSurface::source`, for messages
/// @throws GeometryError  if two files have the same triangle in different zones, or nothing is
///                        left
void remove_invalid_triangles(RawSurface& surface, const std::vector<std::string>& files,
                              const std::vector<std::uint16_t>& zone_of_file,
                              TerrainReport& report);

/// Removes fins, and orients triangles consistently with each component facing up over most of its
/// plan area; counts border edges and components.
/// @throws GeometryError  if an edge has more than two triangles, or a component is non-orientable
void orient_upwards(RawSurface& surface, TerrainReport& report);

}  // namespace clast::terrain_detail
