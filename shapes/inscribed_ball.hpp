#pragma once
/// The largest ball inside a closed surface.
#include "mesh/triangle_mesh.hpp"

namespace clast {

struct Ball {
  Vec3 centre = Vec3::Zero();
  double radius = 0.0;  ///< m
};

/// Cubes over the bounds of the mesh are split where they can still hold the centre of a larger
/// ball: no larger ball than 1 + `precision` times the one returned exists.
/// @param mesh  closed, outward-facing
/// @throws GeometryError  no triangle, or no point inside
Ball largest_inscribed_ball(const TriangleMesh& mesh, double precision = 1e-2);

}  // namespace clast
