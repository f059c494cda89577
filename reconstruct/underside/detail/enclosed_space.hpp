#pragma once
/// Space between a closure and planes behind it.
#include <array>
#include <optional>
#include <span>
#include <vector>

#include "reconstruct/underside/underside.hpp"

namespace clast::reconstruct_detail {

using TriangleCorners = std::array<Vec3, 3>;  ///< of a triangle, m

/// Possible space behind a closure, seen from a point inside the body.
struct EnclosedSpace {
  double volume = 0.0;       ///< between closure and planes, m^3
  std::vector<Vec3> points;  ///< on the planes behind the closure, including its vertices
};

/// Computes the space.
/// @param closure  facing out of the body
/// @param centre  point inside all half-spaces n . p <= d, before the closure
/// @param farthest  m
/// @returns empty if a ray through the closure leads beyond `farthest`
std::optional<EnclosedSpace> compute_enclosed_space(std::span<const TriangleCorners> closure,
                                                    const Vec3& centre,
                                                    std::span<const Plane> planes, double farthest);

}  // namespace clast::reconstruct_detail
