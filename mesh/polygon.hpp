#pragma once
/// Triangulation of the polygons of mesh files.
#include <cstdint>
#include <span>

#include "mesh/triangle_mesh.hpp"

namespace clast {

/// Maximum number of vertices for ear clipping, which is cubic and would stall on hostile files.
/// Larger polygons become fans, which is correct for convex ones.
inline constexpr std::size_t kMaxEarClippingVertices = 1000;

/// Appends the triangles of a polygon to `mesh`, by ear clipping, so that concave faces are
/// preserved; quads are split along the better diagonal.
/// @throws InputError  if there are fewer than three vertices, or an index is out of range
///                     (0-based)
void append_polygon(TriangleMesh& mesh, std::span<const std::int64_t> corners);

}  // namespace clast
