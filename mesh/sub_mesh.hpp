#pragma once
/// Extraction of triangles as a mesh of their own.
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace clast {

/// Makes a mesh of `triangles` over the vertices of `source`, without unused vertices, in unchanged
/// order.
TriangleMesh extract_triangles(const TriangleMesh& source,
                               const std::vector<TriangleMesh::Triangle>& triangles);

/// Makes a mesh of the marked triangles, without unused vertices, in unchanged order.
/// @pre one flag per triangle
TriangleMesh extract_triangles(const TriangleMesh& mesh, const std::vector<bool>& keep);

void remove_unused_vertices(TriangleMesh& mesh);

}  // namespace clast
