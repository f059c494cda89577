#pragma once
/// Space between the closure of a hole and the planes that bound the body.
#include <array>
#include <optional>
#include <span>
#include <vector>

#include "reconstruct/underside/underside.hpp"

namespace clast::reconstruct_detail {

using TriangleCorners = std::array<Vec3, 3>;  ///< corners of a triangle, m

/// Space behind a closed hole that the body may fill.
struct EnclosedSpace {
  double volume = 0.0;  ///< volume between closure and planes, m^3
  std::vector<Vec3>
      points;  ///< points on the planes behind the closure, and vertices of the closure
};

/// Computes the space behind the triangles that close a hole, up to planes that bound the body.
/// Rays from `centre` through the triangles fill this space up to the nearest plane.
/// @param closure  triangles that close the hole, facing out of the body
/// @param centre  point inside the body, on the inner side of all planes
/// @param farthest  maximum length of the rays, m
/// @returns empty if a ray reaches no plane within `farthest`
std::optional<EnclosedSpace> compute_enclosed_space(std::span<const TriangleCorners> closure,
                                                    const Vec3& centre,
                                                    std::span<const Plane> planes, double farthest);

}  // namespace clast::reconstruct_detail
