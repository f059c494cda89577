#pragma once
/// Triangulated sphere of nearly equal triangles.
#include "mesh/triangle_mesh.hpp"

namespace clast {

/// Returns the unit sphere as an icosahedron whose faces are divided into frequency^2 triangles
/// each: 10 frequency^2 + 2 vertices, outward.
/// @param frequency  number of parts of an edge, at least 1
TriangleMesh geodesic_sphere(int frequency);

}  // namespace clast
