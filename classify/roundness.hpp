#pragma once
/// Roundness of block corners.
#include "mesh/triangle_mesh.hpp"

namespace clast {

/// Wadell's roundness in three dimensions.
struct Roundness {
  double value =
      1.0;  ///< mean radius of curvature of the corners divided by the radius of the inscribed ball
  double inscribed_radius = 0.0;  ///< radius of the largest inscribed ball, m
  double corner_fraction = 0.0;   ///< fraction of the area that belongs to corners
  double edge_length = 0.0;       ///< mean edge length of the mesh, on which the value depends, m
};

/// Computes the roundness. Corners are points where the largest principal curvature k exceeds 1/R,
/// where R is the radius of the largest inscribed ball. The value is the area-weighted mean of 1/(k
/// R) over the corners, or 1 if there are none. Curvatures at vertices follow from cotangent mean
/// curvature and angle defect. Corner radii are resolved to about one edge length, so only values
/// for equal edge lengths can be compared.
/// @param mesh  closed, outward, with triangles of similar size
/// @throws GeometryError  if the mesh is not closed and oriented, or encloses no volume
/// @cite wadell1932 @cite zhao2016 @cite meyer2003
Roundness roundness(const TriangleMesh& mesh);

}  // namespace clast
