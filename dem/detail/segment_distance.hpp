#pragma once
/// Where two segments come closest.
#include "core/types.hpp"

namespace clast::dem_detail {

struct ClosestOnSegments {
  double first = 0.0;           ///< along the first segment, m
  double second = 0.0;          ///< along the second, m
  Vec3 between = Vec3::Zero();  ///< from the point on the second to the one on the first
  bool crossing = false;        ///< both points are inside, where the lines themselves are closest
};

/// @param a, u  start and unit direction of the first segment; b, v of the second
ClosestOnSegments closest_on_segments(const Vec3& a, const Vec3& u, double length_a, const Vec3& b,
                                      const Vec3& v, double length_b);

}  // namespace clast::dem_detail
