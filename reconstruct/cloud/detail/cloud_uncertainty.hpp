#pragma once
/// Uncertainty of a surface reconstructed from points.
#include <span>

#include "mesh/triangle_mesh.hpp"
#include "reconstruct/cloud/surface_uncertainty.hpp"

namespace clast::reconstruct_detail {

/// Normals, spacings and noise of surface points.
struct PointUncertainty {
  std::span<const Vec3> normals;     ///< unit, outward, one per vertex
  std::span<const double> spacings;  ///< from `compute_local_spacings`, m
  double noise = 0.0;                ///< removed standard deviation, m
};

/// Bounds the true surface. Edges and tips may extend beyond the points as far as the planes
/// through the neighbours allow, with the scatter of these points, and no farther than the largest
/// empty area. A point out of the plane of its neighbours may be noise, so that the block may lack
/// it.
/// @param surface  closed, outward; its vertices are the points
/// @returns inner and outer bounds
SurfaceUncertainty compute_surface_uncertainty(const TriangleMesh& surface,
                                               const PointUncertainty& points);

}  // namespace clast::reconstruct_detail
