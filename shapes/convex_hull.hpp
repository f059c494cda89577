#pragma once
/// Convex hull of points.
#include <span>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace clast {

/// Computes the convex hull of points as a closed, outward-facing mesh. Faces with more than three
/// vertices are fans of triangles. The result is bit-identical for any order of the points.
/// @throws GeometryError  if there are fewer than four points, or if all are coplanar to 1e-12 of
///                        their extent
TriangleMesh convex_hull(std::span<const Vec3> points);

/// Affine span of points: the point, line, plane or space that contains them to 1e-12 of their
/// extent. Its dimension is 0, 1, 2 or 3.
struct AffineSpan {
  int dimension = 0;
  Mat3 axes = Mat3::Identity();  ///< columns: along the line, across it in the plane, normal
};

AffineSpan affine_span(std::span<const Vec3> points);

/// Returns the distinct points in ascending order of x, y, z. Results from these do not depend on
/// the input order.
std::vector<Vec3> sorted_unique_points(std::span<const Vec3> points);

/// Returns the sorted vertices of the convex hull, which may have any dimension from 0 to 3.
/// @throws GeometryError  if a point is not finite
std::vector<Vec3> extreme_points(std::span<const Vec3> points);

}  // namespace clast
