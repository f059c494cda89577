#pragma once
/// Over-segmentation of a deposit into patches bounded by concave lines.
#include <cstdint>
#include <vector>

#include "reconstruct/deposit/detail/oriented_points.hpp"

namespace clast::reconstruct_detail {

/// Patches of a cloud.
struct ConvexPatches {
  std::vector<std::uint32_t> patch_of_point;  ///< one per point
  std::size_t count = 0;
};

/// Segments points by a watershed of their concavities. Two basins join where the concavity between
/// them exceeds the smaller of their minima by less than a threshold. Patches are numbered by their
/// first point.
/// @cite vincent1991
ConvexPatches find_convex_patches(const OrientedPoints& cloud);

}  // namespace clast::reconstruct_detail
