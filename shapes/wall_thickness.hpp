#pragma once
/// Wall thickness of bodies.
#include <optional>

#include "mesh/triangle_mesh.hpp"

namespace clast {

/// Thin wall between two opposite faces of a body.
struct ThinWall {
  double thickness = 0.0;        ///< m
  Vec3 position = Vec3::Zero();  ///< midpoint of the wall
};

/// Finds the thinnest wall. Thickness is measured from the centroid of each triangle inwards to the
/// first face. The two faces must be parallel within 30 degrees, so that sharp edges are not walls.
/// Empty if no faces are opposite, as in a tetrahedron.
/// @param mesh  closed, outward-facing and simplified; otherwise roughness counts as walls
std::optional<ThinWall> find_thinnest_wall(const TriangleMesh& mesh);

}  // namespace clast
