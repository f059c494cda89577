#pragma once
/// Extraction of triangles to a separate mesh.
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace clast {

/// Makes a mesh of `triangles`, whose indices refer to vertices of `source`. Unused vertices are
/// left out; the order is kept.
TriangleMesh extract_triangles(const TriangleMesh& source,
                               const std::vector<TriangleMesh::Triangle>& triangles);

/// Makes a mesh of the marked triangles. Unused vertices are left out; the order is kept.
/// @pre one flag per triangle
TriangleMesh extract_triangles(const TriangleMesh& mesh, const std::vector<bool>& keep);

void remove_unused_vertices(TriangleMesh& mesh);

}  // namespace clast
