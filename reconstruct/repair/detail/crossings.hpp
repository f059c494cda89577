#pragma once
/// Removal of self-intersections with CGAL.
#include "mesh/triangle_mesh.hpp"

namespace clast::reconstruct_detail {

/// Smooths intersecting triangles, or removes them with growing neighbourhoods and refills;
/// degenerate triangles are collapsed. Topology is preserved.
/// @param mesh  closed, oriented 2-manifold
/// @return false if intersections remain; the mesh is then undefined
bool remove_crossings(TriangleMesh& mesh);

}  // namespace clast::reconstruct_detail
