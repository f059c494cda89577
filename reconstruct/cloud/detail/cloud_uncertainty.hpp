#pragma once
/// How far the true surface may lie from the one through points.
#include <span>

#include "mesh/triangle_mesh.hpp"
#include "reconstruct/cloud/surface_uncertainty.hpp"

namespace clast::reconstruct_detail {

/// Points on a surface, and how well they are known.
struct PointUncertainty {
  std::span<const Vec3> normals;     ///< unit, outward, one for each vertex
  std::span<const double> spacings;  ///< as `compute_local_spacings` gives them, m
  double noise = 0.0;                ///< standard deviation that was smoothed away, m
};

/// Edges and tips end between the points. The true surface continues as far as the planes through
/// the neighbours of a point let it, each with the scatter of its own points as leeway, and no
/// farther than a place without any point may be wide. A point that stands out of the plane of its
/// neighbours may be noise: the block may lack it.
/// @returns inner and outer
/// @param surface  closed, outward; its vertices are the points
SurfaceUncertainty compute_surface_uncertainty(const TriangleMesh& surface,
                                               const PointUncertainty& points);

}  // namespace clast::reconstruct_detail
