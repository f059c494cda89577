#pragma once
/// Surfaces of which one point inside sees every part.
#include <optional>

#include "mesh/triangle_mesh.hpp"

namespace clast {

/// A point from which every triangle is seen from inside: the middle of the kernel, which is what
/// lies below the planes of all triangles. A mesh whose vertices move along their rays from there
/// crosses itself nowhere. None: the surface is not star-shaped, or by less than rounding.
/// @param mesh  closed, outward
std::optional<Vec3> find_kernel_point(const TriangleMesh& mesh);

}  // namespace clast
