#pragma once
/// Planes that bound a body if its unobserved part continues the observed flanks.
#include <cstddef>
#include <span>
#include <vector>

#include "mesh/triangle_mesh.hpp"
#include "reconstruct/underside/underside.hpp"

namespace clast::reconstruct_detail {

/// Tangent planes of an observed surface, with outward normals n. The body is inside the
/// half-spaces n . p <= d.
struct FlankPlanes {
  std::vector<Plane> planes;
  double outward_offset = 0.0;  ///< outward offset from the observed surface, m
};

/// Fits tangent planes to patches of the observed surface. They are moved outwards until the
/// observed surface is behind all of them, and by `slack`. The slack is the mean height of patches
/// above the tangent planes of others; it is zero for convex bodies. A convex body is behind all
/// planes, including its unobserved part.
/// @param closed  outward
/// @param observed  number of observed triangles, which are the first ones
/// @param rims  vertices on the rims of holes; planes that only these determine are omitted
FlankPlanes fit_flank_planes(const TriangleMesh& closed, std::size_t observed,
                             std::span<const std::uint32_t> rims);

}  // namespace clast::reconstruct_detail
