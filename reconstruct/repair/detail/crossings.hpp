#pragma once
/// Surfaces that pass through themselves, made ones that don't.
#include "mesh/triangle_mesh.hpp"

namespace clast::reconstruct_detail {

/// Triangles that cross are smoothed, or cut out and filled anew, with more and more of their
/// neighbours; triangles without area are collapsed. Topology is kept.
/// @param mesh  closed, oriented 2-manifold
/// @return false: some cross still; the mesh is then undefined
bool remove_crossings(TriangleMesh& mesh);

}  // namespace clast::reconstruct_detail
