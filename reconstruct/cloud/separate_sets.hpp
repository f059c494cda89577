#pragma once
/// Separation of points far from the block.
#include <cstddef>
#include <span>
#include <vector>

#include "core/types.hpp"

namespace clast::reconstruct_detail {

/// Largest cluster with nearby points, separated from far ones.
struct SeparatedPoints {
  std::vector<Vec3> near;  ///< in the given order
  std::size_t far = 0;     ///< number of excluded points
  double far_area_ratio =
      0.0;  ///< approximate area of the largest far cluster over that of the largest cluster
  Vec3 far_position = Vec3::Zero();  ///< a point of the largest far cluster
};

/// Separates clusters, connected by steps of 1/50 of the diagonal or a few spacings. A cluster is
/// far if its box is farther from that of the largest than a quarter of its diagonal; a partly
/// observed block may consist of two near clusters.
SeparatedPoints separate_far_points(std::span<const Vec3> points);

}  // namespace clast::reconstruct_detail
