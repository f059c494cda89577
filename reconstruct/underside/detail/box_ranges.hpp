#pragma once
/// Bounds of the smallest box of partly unobserved bodies.
#include <span>

#include "shapes/volume_bracket.hpp"

namespace clast::reconstruct_detail {

/// Bounds the sides of the smallest box of any body that contains all of `observed` and nothing
/// outside the convex hull of `possible`.
///
/// The volume of its smallest box is at most that of the smallest box around `possible`. Its axes
/// are therefore among those along which the box of `observed` has at most that volume; along each
/// of them its sides are between the extents of both, limited by that volume. Axes are searched
/// around all local minima of the box of `observed`, and on a grid over all rotations.
/// @param observed  not empty
/// @param possible  including `observed`
SideBounds bound_box_sides(std::span<const Vec3> observed, std::span<const Vec3> possible);

}  // namespace clast::reconstruct_detail
