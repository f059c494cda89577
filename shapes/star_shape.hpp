#pragma once
/// Star-shaped surfaces.
#include <optional>

#include "mesh/triangle_mesh.hpp"

namespace clast {

/// Finds the centroid of the kernel, from which each triangle is seen from inside: the region below
/// the planes of all triangles. Moving vertices along rays from it causes no self-intersection.
/// Empty if the surface is not star-shaped, or only within rounding.
/// @param mesh  closed, outward
std::optional<Vec3> find_kernel_point(const TriangleMesh& mesh);

}  // namespace clast
