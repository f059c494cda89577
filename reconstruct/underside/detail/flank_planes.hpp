#pragma once
/// Planes that bound a body whose flanks continue as observed.
#include <cstddef>
#include <span>
#include <vector>

#include "mesh/triangle_mesh.hpp"
#include "reconstruct/underside/underside.hpp"

namespace clast::reconstruct_detail {

/// Bounding half-spaces n . p <= d with outward normals.
struct FlankPlanes {
  std::vector<Plane> planes;
  double slack = 0.0;  ///< outward offset from the observed surface, m
};

/// Fits tangent planes to patches of the observed surface, moved outwards until it is behind all of
/// them, and by the slack: the mean height of surface parts above the tangent planes of others,
/// zero for convex bodies. A convex body lies behind these planes whatever its unobserved part is
/// like.
/// @param closed  outward
/// @param observed  number of observed triangles, which come first
/// @param rims  rim vertices: planes determined by them alone are omitted
FlankPlanes fit_flank_planes(const TriangleMesh& closed, std::size_t observed,
                             std::span<const std::uint32_t> rims);

}  // namespace clast::reconstruct_detail
