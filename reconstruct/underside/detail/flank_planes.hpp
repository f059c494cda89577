#pragma once
/// Planes that a body stays behind if its flanks continue as they were seen.
#include <cstddef>
#include <span>
#include <vector>

#include "mesh/triangle_mesh.hpp"
#include "reconstruct/underside/underside.hpp"

namespace clast::reconstruct_detail {

/// Half-spaces n . p <= d, normals outward.
struct FlankPlanes {
  std::vector<Plane> planes;
  double slack = 0.0;  ///< m, by which they lie outside of what was seen
};

/// Tangent planes of patches of the seen surface, each moved out until all that was seen lies
/// behind it, and by the slack. A convex body lies behind them, whatever its unseen part is like.
/// The slack is the mean height of parts of the seen surface above the tangent planes of others:
/// zero for a convex body.
/// @param closed  outward
/// @param seen    triangles before this one were seen
/// @param rims    vertices of the rims: a plane that only they hold out is left out
FlankPlanes fit_flank_planes(const TriangleMesh& closed, std::size_t observed,
                         std::span<const std::uint32_t> rims);

}  // namespace clast::reconstruct_detail
