#pragma once
/// Separation of points far from the block.
#include <cstddef>
#include <span>
#include <vector>

#include "core/types.hpp"

namespace clast::reconstruct_detail {

/// Points of the largest cluster and of clusters near it, separated from far points.
struct SeparatedPoints {
  std::vector<Vec3> near_points;  ///< near points, in the given order
  std::size_t far_count = 0;      ///< number of excluded points
  double far_area_ratio =
      0.0;  ///< approximate area of the largest far cluster relative to that of the largest cluster
  Vec3 far_position = Vec3::Zero();  ///< a point of the largest far cluster
};

/// Separates points far from the block. Clusters are points connected by steps of 1/50 of the
/// diagonal or a few spacings. A cluster is far if the distance of its box from that of the largest
/// cluster exceeds a quarter of its diagonal. Nearer clusters are kept, because a partly observed
/// block may consist of two.
SeparatedPoints separate_far_points(std::span<const Vec3> points);

}  // namespace clast::reconstruct_detail
