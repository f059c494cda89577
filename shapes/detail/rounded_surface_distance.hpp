#pragma once
/// Distance of points from the rounded surface of a body.
#include "mesh/triangle_tree.hpp"

namespace clast::shapes_detail {

/// Refers to the tree, which must stay.
class RoundedSurfaceDistance {
 public:
  /// @param farthest  no point that is asked for is farther from the skin
  RoundedSurfaceDistance(const TriangleTree& core, double radius, double farthest)
      : core_(core), radius_(radius), farthest_(farthest) {}

  /// Negative inside the body. Exact outside, and inside wherever the skin over the closest core
  /// point is bare; where it is buried, as under creases, the distance to a bare point near it:
  /// never too small.
  /// @param hint  a core triangle that is likely near; becomes the closest
  double operator()(const Vec3& point, std::uint32_t& hint) const;
  double operator()(const Vec3& point) const {
    std::uint32_t hint = 0;
    return (*this)(point, hint);
  }

 private:
  double exit_distance(const Vec3& point, const Vec3& direction, double longest,
                       std::uint32_t& hint) const;

  const TriangleTree& core_;
  double radius_, farthest_;
};

}  // namespace clast::shapes_detail
