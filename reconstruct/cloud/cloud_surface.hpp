#pragma once
/// Surface reconstruction from the points of a block. Unobserved parts of the surface stay open.
#include <cstddef>
#include <span>

#include "mesh/triangle_mesh.hpp"
#include "reconstruct/cloud/surface_uncertainty.hpp"

namespace clast {

struct CloudSurfaceOptions {
  /// Side of the cubes in which points are averaged, as a fraction of the diagonal. Points are
  /// averaged only if they are closer together than half of this side.
  double averaging_cell = 0.008;
  /// Radius of empty balls above which triangles belong to a hole, in local point spacings.
  double hole_ball_radius = 1.5;
  std::size_t min_points = 500;  ///< minimum number of points of a block
  unsigned threads = 1;          ///< number of threads, 0: one per core; does not affect the result

  void check() const;  ///< throws InputError naming the field and its value
};

struct CloudSurface {
  /// Oriented 2-manifold of one component, outward, m. Closed if the points cover all sides.
  TriangleMesh mesh;
  SurfaceUncertainty uncertainty;  ///< uncertainty of the observed part
  std::size_t outliers = 0;        ///< number of removed points off the surface
  /// Number of filled gaps. Each has less than 0.5 % of the surface area.
  std::size_t gaps = 0;
  double gap_fraction = 0.0;         ///< area of the filled gaps over the surface area
  Vec3 gap_position = Vec3::Zero();  ///< position in the largest gap, m
};

/// Reconstructs the surface of a block from points. Normals are oriented by propagation
/// [hoppe1992], the indicator function is solved [kazhdan2006], and noise is removed by moving
/// least squares [levin2004]. The surface consists of the Delaunay triangles between inside and
/// outside [amenta1999], so each vertex is a point. Parts farther from the points than their
/// spacing explains are unobserved and left open.
/// @param points  points of one block, in any length unit
/// @throws InputError  if there are too few points
/// @throws GeometryError  if the points are coplanar or collinear, or no surface was found
/// @cite hoppe1992 @cite kazhdan2006 @cite levin2004 @cite amenta1999 @cite richardson1911
CloudSurface fit_cloud_surface(std::span<const Vec3> points,
                               const CloudSurfaceOptions& options = {});

}  // namespace clast
