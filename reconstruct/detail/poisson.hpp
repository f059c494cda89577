#pragma once
/// The surface between inside and outside that oriented points tell of.
#include <span>

#include "shapes/triangle_mesh.hpp"

namespace clast::detail {

/// Poisson reconstruction over a Delaunay triangulation: a closed surface, also where there are no
/// points. Empty when none is found.
/// @param edge  about the length of its triangles' edges, m
/// @cite kazhdan2006
TriangleMesh poisson_surface(std::span<const Vec3> points, std::span<const Vec3> normals,
                             double edge);

}  // namespace clast::detail
