#pragma once
/// Points of a scan that lie far from the block.
#include <cstddef>
#include <span>
#include <vector>

#include "core/types.hpp"

namespace clast::reconstruct_detail {

/// The largest set of points and what lies near it, apart from the rest.
struct SeparatedPoints {
  std::vector<Vec3> near;  ///< in the order given
  std::size_t far = 0;     ///< points left out
  double far_area_ratio = 0.0;  ///< area of the largest far set over that of the largest set, about
  Vec3 far_position = Vec3::Zero();  ///< a point of the largest far set
};

/// Sets are linked by steps of a fiftieth of the diagonal or of a few spacings; one whose box lies
/// farther from that of the largest than a quarter of its diagonal is far. A block of which some
/// sides were not seen may well be two sets, near to each other.
SeparatedPoints separate_far_points(std::span<const Vec3> points);

}  // namespace clast::reconstruct_detail
