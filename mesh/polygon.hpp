#pragma once
/// Triangulation of the polygons of mesh files.
#include <cstdint>
#include <span>

#include "mesh/triangle_mesh.hpp"

namespace clast {

/// Maximum number of vertices for ear clipping, whose cost is cubic. Larger polygons become fans of
/// triangles, which is correct if they are convex.
inline constexpr std::size_t kMaxEarClippingVertices = 1000;

/// Appends the triangles of a polygon to `mesh`. Ear clipping preserves concave polygons. Quads are
/// split along the better diagonal.
/// @throws InputError  if there are fewer than three vertices or an index (from 0) is out of range
void append_polygon(TriangleMesh& mesh, std::span<const std::int64_t> corners);

}  // namespace clast
