#pragma once
/// Distance to the surface of a rounded body.
#include "mesh/triangle_tree.hpp"

namespace clast::shapes_detail {

/// Signed distance to a rounded surface. Refers to the tree, which must outlive it.
class RoundedSurfaceDistance {
 public:
  /// Stores the tree.
  /// @param farthest  upper bound of the distances of all queries
  RoundedSurfaceDistance(const TriangleTree& core, double radius, double farthest)
      : core_(core), radius_(radius), farthest_(farthest) {}

  /// Returns the signed distance, negative inside. Exact outside, and inside if the surface over
  /// the closest core point is exposed; otherwise, as under creases, the distance to a near exposed
  /// point, never too small.
  /// @param hint  index of a probably near core triangle; set to the closest
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
