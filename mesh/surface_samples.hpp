#pragma once
/// Random sampling of surfaces.
#include <cstddef>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace clast {

/// Samples points uniformly over the area, one in each of `count` equal parts. The seed is fixed.
std::vector<Vec3> sample_surface(const TriangleMesh& mesh, std::size_t count);

}  // namespace clast
