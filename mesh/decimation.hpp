#pragma once
/// Fewer vertices for a closed mesh, by edge collapses.
#include <cstddef>
#include <optional>

#include "mesh/triangle_mesh.hpp"

namespace clast {

/// Edges are collapsed until `vertices` are left, the cheapest first, each to the point that keeps
/// the volume and changes the surface least; a triangle's normal turns by no more than a right
/// angle. The result may cross itself: `untangle_self_intersections` sees to that. Coordinates near the origin, or
/// digits are lost.
/// @param mesh      closed 2-manifold
/// @param vertices  at least 4; a mesh with no more is returned as it is
/// @cite lindstrom1998
TriangleMesh decimate(const TriangleMesh& mesh, std::size_t vertices);

/// Draws crossing triangles together until none is left; none when that doesn't end, or would
/// change the volume by more than 1e-3.
/// @param mesh  closed 2-manifold
std::optional<TriangleMesh> untangle_self_intersections(TriangleMesh mesh);

}  // namespace clast
