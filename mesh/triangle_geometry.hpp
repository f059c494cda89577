#pragma once
/// Area, normal, middle and angles of single triangles, and the typical length of their sides.
#include <cstddef>

#include "mesh/triangle_mesh.hpp"

namespace clast {

/// Twice the area along the normal, m^2; of a triangle seen from above, z is twice its plan area.
Vec3 area_vector(const TriangleMesh& mesh, const TriangleMesh::Triangle& triangle);

/// Zero for a triangle without area.
Vec3 unit_normal(const TriangleMesh& mesh, const TriangleMesh::Triangle& triangle);

Vec3 centroid(const TriangleMesh& mesh, const TriangleMesh::Triangle& triangle);

/// Angle at corner `k`, rad.
double corner_angle(const TriangleMesh& mesh, const TriangleMesh::Triangle& triangle,
                    std::size_t k);

/// The median length of the sides of all triangles, m.
/// @pre there is a triangle
double median_edge_length(const TriangleMesh& mesh);

}  // namespace clast
