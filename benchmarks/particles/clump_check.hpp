#pragma once
/// Errors of a clump by random points, without the formulas that clast uses.
#include <span>

#include "mesh/triangle_tree.hpp"
#include "particles/shape_errors.hpp"

namespace clast {

/// Errors by random points: 1e7 in the box of the union for volume and inertia tensor, and 1e5 on
/// each surface for the largest distance from the other one.
struct ClumpCheck {
  ShapeErrors errors;
  double volume_deviation = 0.0;  ///< standard deviation of `errors.volume`
};

/// @param body  closed mesh whose solid has the mass properties
ClumpCheck check_clump(const ParticleBody& body, const TriangleTree& tree,
                       std::span<const Ball> balls, std::uint64_t seed);

}  // namespace clast
