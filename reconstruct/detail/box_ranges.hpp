#pragma once
/// What an unseen part leaves open of the sides of the smallest box.
#include <span>

#include "reconstruct/underside.hpp"

namespace clast::detail {

/// Bounds of the sides of the smallest box of every body that holds all of `seen` and stands out
/// of the convex hull of `possible` by no more than `margin`.
///
/// The box of such a body has at most the volume of the smallest box around `possible`, grown by
/// the margin. So its axes are among those along which the box of `seen` has no more than that, and
/// along each of them its sides lie between the extents of the two, and a side is no longer than
/// leaves that volume to the others. Axes are looked at on a grid that is dense where the box of
/// `seen` is small.
/// @param seen      at least one point
/// @param possible  `seen` among them
/// @param margin    m
SideBounds box_ranges(std::span<const Vec3> seen, std::span<const Vec3> possible, double margin);

}  // namespace clast::detail
