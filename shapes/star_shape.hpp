#pragma once
/// Star-shaped surfaces.
#include <optional>

#include "mesh/triangle_mesh.hpp"

namespace clast {

/// Finds the centroid of the kernel, which is the region below the planes of all triangles. From
/// there, all triangles are visible from inside. Moving vertices along rays from it causes no
/// self-intersection. Empty if the surface is not star-shaped beyond rounding errors.
/// @param mesh  closed, outward
std::optional<Vec3> find_kernel_centroid(const TriangleMesh& mesh);

}  // namespace clast
