#pragma once
/// Convex hull of points.
#include <span>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace clast {

/// The hull as a closed, outward mesh that holds only extreme points. Faces of more than three
/// corners are fans from the first of them. Same bits for any order of the points.
/// @throws GeometryError  fewer than four points, or all in one plane (to 1e-12 of their extent)
TriangleMesh convex_hull(std::span<const Vec3> points);

/// What points span: nothing (0, also for no points), a line (1), a plane (2) or space (3), to
/// 1e-12 of their extent.
struct AffineSpan {
  int dimension = 0;
  Mat3 axes = Mat3::Identity();  ///< columns: along the line; then across it in the plane; normal
};

AffineSpan affine_span(std::span<const Vec3> points);

/// Points in ascending order of x, y, z, each once: what makes a result independent of the order
/// in which points come.
std::vector<Vec3> sorted_unique_points(std::span<const Vec3> points);

/// Corners of the convex hull, sorted: of the hull, of the outline of points in a plane, the ends
/// of a line, or the one place.
/// @throws GeometryError  a point is not finite
std::vector<Vec3> extreme_points(std::span<const Vec3> points);

}  // namespace clast
