#pragma once
/// Polygons of a mesh file cut into triangles.
#include <cstdint>
#include <span>

#include "mesh/triangle_mesh.hpp"

namespace clast {

/// Corners up to which ears are cut; cutting is cubic and would stall on a hostile file. Above it a
/// fan is taken, which is right for convex polygons.
inline constexpr std::size_t kMaxEarClippingVertices = 1000;

/// Appends the polygon's triangles to `mesh`, whose vertices it names: ears are cut off where they
/// are convex and empty, so that concave faces stay themselves; of a quad the better diagonal.
/// @throws InputError  fewer than three corners, or a number past the vertices (0-based)
void append_polygon(TriangleMesh& mesh, std::span<const std::int64_t> corners);

}  // namespace clast
