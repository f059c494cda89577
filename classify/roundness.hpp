#pragma once
/// Roundness of block corners.
#include "mesh/triangle_mesh.hpp"

namespace clast {

/// Wadell's roundness in three dimensions.
struct Roundness {
  double value =
      1.0;  ///< mean radius of curvature of the corners over the radius of the inscribed ball
  double inscribed_radius = 0.0;  ///< of the largest ball inside, m
  double corner_fraction = 0.0;   ///< fraction of the area in corners
  double edge_length = 0.0;       ///< mean edge length of the mesh, m, on which the value depends
};

/// Computes the roundness. Corners are points where the largest principal curvature k exceeds 1/R
/// of the largest inscribed ball; the value is the area-weighted mean of 1/(k R) over the corners,
/// 1 if there are none. Vertex curvatures: cotangent mean curvature and angle-defect Gaussian
/// curvature over the vertex area. Corner radii are resolved to about one edge length, so that only
/// values at equal edge length can be compared.
/// @param mesh  closed, outward-facing, evenly triangulated
/// @throws GeometryError  if the mesh is not closed and oriented, or has no inside
/// @cite wadell1932 @cite zhao2016 @cite meyer2003
Roundness roundness(const TriangleMesh& mesh);

}  // namespace clast
