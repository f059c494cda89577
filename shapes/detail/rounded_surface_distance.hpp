#pragma once
/// Distance to the surface of a rounded body.
#include "mesh/triangle_tree.hpp"

namespace clast::shapes_detail {

/// Signed distance to the surface of a rounded body. The tree must outlive this object.
class RoundedSurfaceDistance {
 public:
  /// Constructs the distance function of a rounded body.
  /// @param farthest  upper bound of the distances in all queries, m
  RoundedSurfaceDistance(const TriangleTree& core, double radius, double farthest)
      : core_(core), radius_(radius), farthest_(farthest) {}

  /// Returns the signed distance, negative inside. It is exact outside, and inside if the surface
  /// over the closest core point is exposed. Otherwise, as under creases, it is the distance to a
  /// near exposed point, which is never too small.
  /// @param hint  index of a core triangle that is probably near; set to the closest one
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
