#pragma once
/// Joining vertices that a file stored more than once.
#include "mesh/triangle_mesh.hpp"

namespace clast {

/// Vertices closer than `tolerance` (m) become one, at the position of the first; triangles that
/// lose a corner by it and exact duplicates are dropped, unused vertices too. Order is kept.
TriangleMesh welded(const TriangleMesh& mesh, double tolerance);

}  // namespace clast
