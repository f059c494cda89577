#pragma once
/// Removal of self-intersections with CGAL.
#include "mesh/triangle_mesh.hpp"

namespace clast::reconstruct_detail {

/// Smooths intersecting triangles, or removes them and their neighbours and refills the holes.
/// Degenerate triangles are collapsed. The topology is preserved.
/// @param mesh  closed, oriented 2-manifold
/// @return false if intersections remain; the state of the mesh is then unspecified
bool replace_intersecting_triangles(TriangleMesh& mesh);

}  // namespace clast::reconstruct_detail
