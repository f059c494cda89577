#pragma once
/// How rounded the corners of a block are.
#include "mesh/triangle_mesh.hpp"

namespace clast {

/// Wadell's roundness in three dimensions, and what it was measured on.
struct Roundness {
  double value = 1.0;             ///< mean radius of the corners over that of the inscribed ball
  double inscribed_radius = 0.0;  ///< of the largest ball inside, m
  double corner_fraction = 0.0;      ///< of the area that is corners
  double edge_length = 0.0;       ///< mean of the mesh, m; the value depends on it
};

/// A corner is where the surface is more curved than the largest ball inside: its largest principal
/// curvature k is above 1/R. The value is the mean of 1/(k R) over the area of the corners, 1 when
/// there are none. Curvatures are those of the vertices of the mesh: mean curvature by cotangents,
/// Gaussian by the defect of angles, each over the vertex's part of the area. A corner's radius
/// is known to about the length of the mesh's edges, so only values at the same edge length
/// compare.
/// @param mesh  closed, outward-facing, of even triangles
/// @throws GeometryError  the mesh is not closed and oriented, or has nothing inside
/// @cite wadell1932 @cite zhao2016 @cite meyer2003
Roundness roundness(const TriangleMesh& mesh);

}  // namespace clast
