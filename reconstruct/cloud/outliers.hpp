#pragma once
/// Points that lie off the surface of the others.
#include <cstdint>
#include <span>
#include <vector>

#include "core/types.hpp"

namespace clast::reconstruct_detail {

/// Every place once, in the order given: scanners and merged files repeat points to the bit, and of
/// such the spacing would be none.
std::vector<Vec3> remove_duplicate_points(std::span<const Vec3> points);

/// How far apart the points lie around each of them: 1/sqrt(density) of points scattered over a
/// surface, from the distance of the sixth nearest, m. It follows the density from place to place.
/// @pre more than six points
std::vector<double> compute_local_spacings(std::span<const Vec3> points);

/// Numbers of the points that are no outliers, in order. An outlier is isolated (its own spacing is
/// much larger than that of its neighbours) and off the plane through these, by more than their
/// spacing and their scatter allow: a point in a sparse part of the cloud, or at its border, is not
/// an outlier. No fixed share of the points is discarded: of a clean cloud every point is kept.
std::vector<std::uint32_t> find_non_isolated_points(std::span<const Vec3> points);

}  // namespace clast::reconstruct_detail
