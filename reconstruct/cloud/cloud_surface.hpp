#pragma once
/// Surface reconstruction from the points of one block, open where it was not observed.
#include <cstddef>
#include <span>

#include "mesh/triangle_mesh.hpp"
#include "reconstruct/cloud/surface_uncertainty.hpp"

namespace clast {

struct CloudSurfaceOptions {
  /// Side of averaging cubes as a fraction of the diagonal; used if points are closer together than
  /// half of it.
  double averaging_cell = 0.008;
  /// Radius of an empty ball at the border of a hole, in local point spacings.
  double hole_ball_radius = 1.5;
  std::size_t min_points = 500;  ///< minimum number of points of a block

  void check() const;  ///< throws InputError naming the field and its value
};

struct CloudSurface {
  /// Oriented 2-manifold of one component, outward; closed if points are all around; m.
  TriangleMesh mesh;
  SurfaceUncertainty uncertainty;  ///< of the observed part
  std::size_t outliers = 0;        ///< number of points off the surface
  /// Number of filled gaps, each below 0.5 % of the area.
  std::size_t gaps = 0;
  double gap_fraction = 0.0;         ///< of the area
  Vec3 gap_position = Vec3::Zero();  ///< in the largest gap, m
};

/// Reconstructs a surface: orients normals by propagation [hoppe1992], solves for the indicator
/// function [kazhdan2006], removes noise by moving least squares [levin2004], and extracts the
/// Delaunay triangles between inside and outside [amenta1999], so that each vertex is a point.
/// Parts farther from the points than their spacing explains are unobserved and left open.
/// @param points  of one block, in any length unit
/// @throws InputError  if there are too few points
/// @throws GeometryError  if the points are coplanar or collinear, or no surface was found
/// @cite hoppe1992 @cite kazhdan2006 @cite levin2004 @cite amenta1999 @cite richardson1911
CloudSurface fit_cloud_surface(std::span<const Vec3> points,
                               const CloudSurfaceOptions& options = {});

}  // namespace clast
