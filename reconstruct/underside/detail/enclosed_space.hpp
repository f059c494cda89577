#pragma once
/// The space between a closure and planes behind it.
#include <array>
#include <optional>
#include <span>
#include <vector>

#include "reconstruct/underside/underside.hpp"

namespace clast::reconstruct_detail {

using TriangleCorners = std::array<Vec3, 3>;  ///< of a triangle, m

/// What may lie behind a closure, seen from a place within the body.
struct EnclosedSpace {
  double volume = 0.0;       ///< between closure and planes, m^3
  std::vector<Vec3> points;  ///< on the planes, behind the closure, its corners among them
};

/// @param closure   faces out of the body
/// @param centre    a place within all half-spaces n . p <= d, before the closure
/// @param farthest  m
/// @returns none where a way through the closure leads farther than `farthest`
std::optional<EnclosedSpace> compute_enclosed_space(std::span<const TriangleCorners> closure, const Vec3& centre,
                                            std::span<const Plane> planes, double farthest);

}  // namespace clast::reconstruct_detail
