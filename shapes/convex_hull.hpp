#pragma once
/// Convex hull of points.
#include <span>

#include "shapes/triangle_mesh.hpp"

namespace clast {

/// The hull as a closed, outward mesh that holds only extreme points.
/// @throws GeometryError  fewer than four points, or all in one plane (to 1e-12 of their extent)
TriangleMesh convex_hull(std::span<const Vec3> points);

}  // namespace clast
