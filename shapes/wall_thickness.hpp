#pragma once
/// How thin a body gets.
#include <optional>

#include "mesh/triangle_mesh.hpp"

namespace clast {

/// A wall: two faces of a body back to back.
struct ThinWall {
  double thickness = 0.0;     ///< m
  Vec3 position = Vec3::Zero();  ///< middle of the wall
};

/// The thinnest wall: from the middle of every triangle straight inwards to the first face that is
/// met, where that is parallel to the triangle within 30 degrees. So a sharp edge is no wall,
/// however little rock is behind its faces. None: no two faces are back to back, as in a
/// tetrahedron.
/// @param mesh  closed, outward; simplified, or the roughness of a scan passes for walls
std::optional<ThinWall> find_thinnest_wall(const TriangleMesh& mesh);

}  // namespace clast
