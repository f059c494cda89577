#pragma once
/// Points of one block to a surface, open where nobody saw it.
#include <cstddef>
#include <span>

#include "mesh/triangle_mesh.hpp"
#include "reconstruct/cloud/surface_uncertainty.hpp"

namespace clast {

/// How a surface is put through points.
struct CloudSurfaceOptions {
  /// Points that lie closer together than half of this share of the diagonal are averaged in cubes
  /// of this side.
  double averaging_cell = 0.008;
  /// Where a hole ends: the radius of a ball that touches the surface and no point, in spacings of
  /// the points around it.
  double hole_ball_radius = 1.5;
  std::size_t min_points = 500;  ///< fewer points make no block

  void check() const;  ///< throws InputError naming the field and its value
};

/// A surface through points, and what was done to get it.
struct CloudSurface {
  /// An oriented 2-manifold in one component, outward; closed where points are all around. m
  TriangleMesh mesh;
  SurfaceUncertainty uncertainty;  ///< what the points leave open of the part that was seen
  std::size_t outliers = 0;        ///< points left out because they lie off the surface
  /// Places where points are missing, each with less than 0.5 % of the area: filled.
  std::size_t gaps = 0;
  double gap_fraction = 0.0;         ///< of the area
  Vec3 gap_position = Vec3::Zero();  ///< in the largest gap, m
};

/// Turns normals outward from neighbour to neighbour [hoppe1992], solves for the indicator of
/// inside and outside [kazhdan2006], smooths the noise away with moving least squares [levin2004],
/// and takes the Delaunay triangles between inside and outside [amenta1999]: every vertex is a
/// point. A part of the surface farther from the points than their spacing explains was not seen,
/// and is left open.
/// @param points  of one block, in any unit of length
/// @throws InputError     too few points
/// @throws GeometryError  the points lie in a plane or on a line, or no surface was found
/// @cite hoppe1992 @cite kazhdan2006 @cite levin2004 @cite amenta1999 @cite richardson1911
CloudSurface fit_cloud_surface(std::span<const Vec3> points,
                               const CloudSurfaceOptions& options = {});

}  // namespace clast
