#pragma once
/// Bounds of the sides of the smallest box around a partly unobserved body.
#include <span>

#include "shapes/volume_bracket.hpp"

namespace clast::reconstruct_detail {

/// Bounds the sides of the smallest box of any body that contains all points `observed` and is
/// inside the convex hull of `possible`.
///
/// The volume of this box is at most that of the smallest box around `possible`. Its axes are
/// therefore among those along which the box of `observed` has at most this volume. Along such
/// axes, each side is between the extents of `observed` and `possible`. Axes are searched around
/// all local minima of the box of `observed`, and on a grid over all rotations.
/// @param observed  not empty
/// @param possible  points that include `observed`
BoxSideBounds bound_box_sides(std::span<const Vec3> observed, std::span<const Vec3> possible);

}  // namespace clast::reconstruct_detail
