#pragma once
/// Area, normal, centroid and angles of triangles, and median edge length.
#include <cstddef>

#include "mesh/triangle_mesh.hpp"

namespace clast {

/// Returns the normal of a triangle, with the length of twice its area, m^2. Its z component is
/// twice the signed plan area.
Vec3 doubled_area_vector(const TriangleMesh& mesh, const TriangleMesh::Triangle& triangle);

/// Returns the unit normal; zero for a degenerate triangle.
Vec3 unit_normal(const TriangleMesh& mesh, const TriangleMesh::Triangle& triangle);

Vec3 centroid(const TriangleMesh& mesh, const TriangleMesh::Triangle& triangle);

/// Returns the angle of a triangle at its vertex `k`, rad.
double corner_angle(const TriangleMesh& mesh, const TriangleMesh::Triangle& triangle,
                    std::size_t k);

/// Returns the median edge length over all triangles, m.
/// @pre the mesh is not empty
double median_edge_length(const TriangleMesh& mesh);

}  // namespace clast
