#pragma once
/// Decimation of closed meshes by edge collapses.
#include <cstddef>
#include <optional>

#include "mesh/triangle_mesh.hpp"

namespace clast {

/// Collapses edges, the cheapest first, until `vertices` vertices are left (Lindstrom-Turk). Each
/// edge is collapsed to the point that preserves the volume and minimises the change of the
/// surface. Triangle normals rotate by at most a right angle. The result may intersect itself
/// (`untangle_self_intersections`). The mesh must be near the origin to keep precision.
/// @param mesh  closed 2-manifold
/// @param vertices  target number of vertices, at least 4; smaller meshes are returned unchanged
/// @cite lindstrom1998
TriangleMesh decimate_mesh(const TriangleMesh& mesh, std::size_t vertices);

/// Collapses edges of intersecting triangles until no triangles intersect. Returns empty if this
/// does not converge, or if the volume changes by more than 0.1 %.
/// @param mesh  closed 2-manifold
std::optional<TriangleMesh> untangle_self_intersections(TriangleMesh mesh);

}  // namespace clast
