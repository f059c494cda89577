#pragma once
/// Convex hull of points.
#include <span>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace clast {

/// Computes the hull as a closed, outward mesh of the extreme points. Faces of more than three
/// vertices are fans from the first of them. Same bits for any order of the points.
/// @throws GeometryError  if there are fewer than four points, or all are coplanar (to 1e-12 of
///                        their extent)
TriangleMesh convex_hull(std::span<const Vec3> points);

/// Affine span of points: 0 (one point or none), 1 (line), 2 (plane) or 3, to 1e-12 of their
/// extent.
struct AffineSpan {
  int dimension = 0;
  Mat3 axes = Mat3::Identity();  ///< columns: along the line; perpendicular in the plane; normal
};

AffineSpan affine_span(std::span<const Vec3> points);

/// Returns the unique points in ascending order of x, y, z, which makes results independent of the
/// input order.
std::vector<Vec3> sorted_unique_points(std::span<const Vec3> points);

/// Returns the sorted vertices of the convex hull, which may be three-, two- or one-dimensional or
/// a point.
/// @throws GeometryError  if a point is not finite
std::vector<Vec3> extreme_points(std::span<const Vec3> points);

}  // namespace clast
