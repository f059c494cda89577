#pragma once
/// Bounds of the sides of the smallest box of a body with an unseen part.
#include <span>

#include "shapes/volume_bracket.hpp"

namespace clast::reconstruct_detail {

/// Bounds of the sides of the smallest box of every body that holds all of `observed` and nothing
/// outside the convex hull of `possible`.
///
/// The box of such a body has at most the volume of the smallest box around `possible`. So its axes
/// are among those along which the box of `observed` has no more than that; along each of them its
/// sides lie between the extents of the two, and a side is no longer than leaves that volume to the
/// others. Axes are looked at around every place where the box of `observed` has a least volume, and on
/// a grid over all turns.
/// @param seen      at least one point
/// @param possible  `observed` among them
SideBounds bound_box_sides(std::span<const Vec3> observed, std::span<const Vec3> possible);

}  // namespace clast::reconstruct_detail
