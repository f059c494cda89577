#pragma once
/// Some triangles of a mesh as a mesh of their own.
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace clast {

/// `triangles` over the vertices of `source`, unused vertices left out, orders kept.
TriangleMesh extract_triangles(const TriangleMesh& source,
                       const std::vector<TriangleMesh::Triangle>& triangles);

/// The mesh with only the triangles that `keep` says, without unused vertices, orders kept.
/// @pre one flag for each triangle
TriangleMesh extract_triangles(const TriangleMesh& mesh, const std::vector<bool>& keep);

void remove_unused_vertices(TriangleMesh& mesh);

}  // namespace clast
