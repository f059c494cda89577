#pragma once
/// Removal of duplicates and isolated outliers.
#include <cstdint>
#include <span>
#include <vector>

#include "core/types.hpp"

namespace clast::reconstruct_detail {

/// Removes duplicate points, as written by scanners and merged files, in unchanged order.
std::vector<Vec3> remove_duplicate_points(std::span<const Vec3> points);

/// Computes the local point spacing, m: 1/sqrt(density) of points scattered over a surface, from
/// the distance of the sixth nearest point.
/// @pre more than six points
std::vector<double> compute_local_spacings(std::span<const Vec3> points);

/// Returns the ascending indices of points that are not outliers. An outlier is isolated (its
/// spacing is much larger than that of its neighbours) and off their plane by more than their
/// spacing and scatter; points in sparse areas or at borders are not outliers. No fixed fraction is
/// removed: clean clouds keep all points.
std::vector<std::uint32_t> find_non_isolated_points(std::span<const Vec3> points);

}  // namespace clast::reconstruct_detail
