#pragma once
/// Repair of raw surfaces for contact search: welding, removal of invalid triangles, orientation.
#include <string>
#include <vector>

#include "terrain/raw_surface.hpp"
#include "terrain/terrain.hpp"

namespace clast::terrain_detail {

/// Merges vertices within 1e-6 m. Surveys can have edges below 1 mm, which are kept.
void weld_surface(RawSurface& surface, TerrainReport& report);

/// Removes triangles that have a repeated vertex, are lower than 1e-9 m or duplicate, and unused
/// vertices.
/// @param files  names of the files to which `RawSurface::source_file` refers, for messages
/// @throws GeometryError  if a triangle is in two files with different zones, or none is left
void remove_invalid_triangles(RawSurface& surface, const std::vector<std::string>& files,
                              const std::vector<std::uint16_t>& zone_of_file,
                              TerrainReport& report);

/// Removes fins and orients the triangles consistently. Each component then faces up over most of
/// its plan area. Border edges and components are counted in `report`.
/// @throws GeometryError  if an edge is non-manifold, or if a component is non-orientable
void orient_upwards(RawSurface& surface, TerrainReport& report);

}  // namespace clast::terrain_detail
