#pragma once
/// Seam between two touching bodies joined in one surface.
#include <optional>

#include "mesh/plane.hpp"
#include "mesh/triangle_mesh.hpp"

namespace clast::reconstruct_detail {

/// Plane section at which two touching bodies may be joined. Lengths are in metres.
struct BodySeam {
  Vec3 position = Vec3::Zero();   ///< centroid of the section
  double width = 0.0;             ///< square root of the section area
  double smaller_fraction = 0.0;  ///< volume fraction of the smaller side
  double ratio = 0.0;  ///< section area relative to the largest section area of the thinner side
  Plane plane;         ///< normal towards the smaller side
};

/// Finds the plane at which two touching bodies may be joined. The section is narrower than the
/// body on both sides of the plane. The convex hulls of both parts together are clearly smaller
/// than the hull of the whole. The surface is concave along most of the outline of the section,
/// unless the section is very narrow. A notch is concave along a part of the outline only.
/// @param closed  outward
/// @returns empty if there is no such plane
std::optional<BodySeam> find_body_seam(const TriangleMesh& closed);

}  // namespace clast::reconstruct_detail
