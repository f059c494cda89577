#pragma once
/// The seam between two bodies that one surface joins: a block and the neighbour that it touches.
#include <optional>

#include "mesh/plane.hpp"
#include "mesh/triangle_mesh.hpp"

namespace clast::reconstruct_detail {

/// A plane section that divides a body into two, m.
struct BodySeam {
  Vec3 position = Vec3::Zero();      ///< centroid of the section
  double width = 0.0;             ///< square root of the area of the section
  double smaller_fraction = 0.0;  ///< of the volume, on the side that has less
  double ratio = 0.0;  ///< area of the section over the smaller of the largest ones beside it
  Plane plane;         ///< of the section, normal towards the side that has less
};

/// Finds the plane along which a body looks like two that touch. The section is narrower than the
/// body is on both sides, the convex hulls of the two parts are together clearly smaller than the
/// hull of the whole, and the surface is concave along most of the outline, or the section is very
/// narrow. A notch in one side of a rock is concave along a part of the outline alone.
///
/// @param closed  outward
/// @returns none if there is no such plane
std::optional<BodySeam> find_body_seam(const TriangleMesh& closed);

}  // namespace clast::reconstruct_detail
