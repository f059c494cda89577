#pragma once
/// Uncertainty of a surface reconstructed from points.
#include <span>

#include "mesh/triangle_mesh.hpp"
#include "reconstruct/cloud/surface_uncertainty.hpp"

namespace clast::reconstruct_detail {

/// Normals, spacings and noise of surface points.
struct SurfacePointStatistics {
  std::span<const Vec3> normals;     ///< unit normals, outward, one per vertex
  std::span<const double> spacings;  ///< local point spacings (`compute_local_spacings`), m
  double noise = 0.0;                ///< standard deviation of the removed noise, m
};

/// Computes bounds of the true surface behind points. Outer bound: edges and tips may extend beyond
/// the points to the planes through their neighbours, including scatter, and at most by a few point
/// spacings. Inner bound: a point above the plane of its neighbours may be noise and not belong to
/// the block.
/// @param surface  closed, outward; its vertices are the points
/// @returns inner and outer bounds
SurfaceUncertainty compute_surface_uncertainty(const TriangleMesh& surface,
                                               const SurfacePointStatistics& points);

}  // namespace clast::reconstruct_detail
