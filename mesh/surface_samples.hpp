#pragma once
/// Points spread over surfaces.
#include <cstddef>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace clast {

/// Points spread evenly over the area: one per equal share of it, at a random place there. Fixed
/// seed: the same mesh gives the same points.
std::vector<Vec3> sample_surface(const TriangleMesh& mesh, std::size_t count);

}  // namespace clast
