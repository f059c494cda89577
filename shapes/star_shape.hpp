#pragma once
/// Star-shaped surfaces.
#include <optional>

#include "mesh/triangle_mesh.hpp"

namespace clast {

/// Finds the centroid of the kernel of a star-shaped surface. The kernel is the region below the
/// planes of all triangles, from which all triangles are visible. Moving vertices along rays from
/// it causes no self-intersection. Empty if the surface is not star-shaped beyond rounding errors.
/// @param mesh  closed, outward
std::optional<Vec3> find_kernel_centroid(const TriangleMesh& mesh);

}  // namespace clast
