#pragma once
/// Decimation of closed meshes by edge collapses.
#include <cstddef>
#include <optional>

#include "mesh/triangle_mesh.hpp"

namespace clast {

/// Collapses edges, the cheapest first, until `vertices` are left, each to the point that preserves
/// the volume and minimises the change of the surface (Lindstrom-Turk); triangle normals rotate by
/// at most a right angle. The result may intersect itself: see `untangle_self_intersections`.
/// Coordinates must be near the origin to keep precision.
/// @param mesh  closed 2-manifold
/// @param vertices  at least 4; smaller meshes are returned unchanged
/// @cite lindstrom1998
TriangleMesh decimate(const TriangleMesh& mesh, std::size_t vertices);

/// Collapses intersecting triangles until none is left; empty if that does not converge or would
/// change the volume by more than 1e-3.
/// @param mesh  closed 2-manifold
std::optional<TriangleMesh> untangle_self_intersections(TriangleMesh mesh);

}  // namespace clast
