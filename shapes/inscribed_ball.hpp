#pragma once
/// Largest ball inside a closed surface.
#include "mesh/triangle_mesh.hpp"

namespace clast {

struct Ball {
  Vec3 centre = Vec3::Zero();
  double radius = 0.0;  ///< m
};

/// Finds the largest inscribed ball by branch and bound. The radius of the largest ball is at most
/// 1 + `precision` times the returned one.
/// @param mesh  closed, outward-facing
/// @throws GeometryError  if the mesh has no triangles or no point is inside
Ball largest_inscribed_ball(const TriangleMesh& mesh, double precision = 1e-2);

}  // namespace clast
