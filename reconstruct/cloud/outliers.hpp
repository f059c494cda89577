#pragma once
/// Removal of duplicates and isolated outliers.
#include <cstdint>
#include <span>
#include <vector>

#include "core/types.hpp"

namespace clast::reconstruct_detail {

/// Returns, for each point, the index of the first point with the same coordinates.
std::vector<std::uint32_t> find_first_duplicates(std::span<const Vec3> points);

/// Computes the local spacing of each point, m. The spacing is 1/sqrt(n), where the number n of
/// points per area is estimated from the distance to the sixth nearest point.
/// @pre more than six points
std::vector<double> compute_local_spacings(std::span<const Vec3> points);

/// Returns the ascending indices of points that are not outliers. An outlier has a much larger
/// spacing than its neighbours, and its distance from their plane exceeds their spacing and
/// scatter. Points in sparse areas or at borders are not outliers. A clean cloud keeps all points.
std::vector<std::uint32_t> find_non_isolated_points(std::span<const Vec3> points);

}  // namespace clast::reconstruct_detail
