#pragma once
/// Distance to the surface of a rounded body.
#include "mesh/triangle_tree.hpp"

namespace clast::shapes_detail {

/// Signed distance of a point from a rounded surface, m; negative inside.
struct SurfaceDistance {
  double value = 0.0;
  bool is_exact = true;  ///< false: the magnitude is an upper bound
};

/// Signed distance to a rounded surface. The tree must outlive this object.
class RoundedSurfaceDistance {
 public:
  /// Constructs the distance function of a rounded body.
  /// @param farthest  upper bound of the distances in all queries, m
  RoundedSurfaceDistance(const TriangleTree& core, double radius, double farthest)
      : core_(core), radius_(radius), farthest_(farthest) {}

  /// Returns the signed distance. It is exact outside, and inside if the surface over the closest
  /// core point is exposed. Otherwise, as under creases, its magnitude is the distance to a near
  /// exposed point.
  /// @param hint  index of a core triangle that is probably near; set to the closest one
  SurfaceDistance operator()(const Vec3& point, std::uint32_t& hint) const;

 private:
  double exit_distance(const Vec3& point, const Vec3& direction, double longest,
                       std::uint32_t& hint) const;

  const TriangleTree& core_;
  double radius_, farthest_;
};

}  // namespace clast::shapes_detail
