#pragma once
/// A raw surface made fit for contact: welded, without degenerate triangles, normals up.
#include <string>
#include <vector>

#include "terrain/raw_surface.hpp"
#include "terrain/terrain.hpp"

namespace clast::terrain_detail {

/// Vertices within 1e-6 m become one. Real ground has edges under 1 mm: only copies are joined.
void weld_surface(RawSurface& surface, TerrainReport& report);

/// Drops triangles with a repeated corner or lower than 1e-9 m, and copies of a triangle; then
/// vertices that nothing uses.
/// @param files  of `RawSurface::source`, for messages
/// @throws GeometryError  two files hold the same triangle under different zones, or nothing is
/// left
void remove_invalid_triangles(RawSurface& surface, const std::vector<std::string>& files,
                            const std::vector<std::uint16_t>& zone_of_file, TerrainReport& report);

/// Drops fins, and turns triangles so that neighbours agree and every component faces up over most
/// of its plan area; counts border edges and components.
/// @throws GeometryError  an edge with more than two triangles, or a component with one side only
void orient_upwards(RawSurface& surface, TerrainReport& report);

}  // namespace clast::terrain_detail
