#pragma once
/// Space between the closure of a hole and the planes that bound the body.
#include <array>
#include <optional>
#include <span>
#include <vector>

#include "reconstruct/underside/underside.hpp"

namespace clast::reconstruct_detail {

using TriangleCorners = std::array<Vec3, 3>;  ///< corners of a triangle, m

/// Space behind a closure, as seen from a point inside the body, that the body may fill.
struct EnclosedSpace {
  double volume = 0.0;  ///< volume between closure and planes, m^3
  std::vector<Vec3>
      points;  ///< points on the planes behind the closure, and vertices of the closure
};

/// Computes the space between the closure of a hole and planes that bound the body.
/// @param closure  triangles that face out of the body
/// @param centre  point inside the body and inside the half-spaces n . p <= d of all planes
/// @param farthest  maximum distance from `centre`, m
/// @returns empty if a ray through the closure leads beyond `farthest`
std::optional<EnclosedSpace> compute_enclosed_space(std::span<const TriangleCorners> closure,
                                                    const Vec3& centre,
                                                    std::span<const Plane> planes, double farthest);

}  // namespace clast::reconstruct_detail
