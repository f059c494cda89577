#pragma once
/// A plane in space, and what it cuts off.
#include <vector>

#include "core/types.hpp"

namespace clast {

/// All p with n . p = d, with the unit normal n.
struct Plane {
  Vec3 normal = Vec3::UnitZ();
  double distance = 0.0;  ///< d, m

  double signed_distance(const Vec3& point) const { return normal.dot(point) - distance; }
};

/// The part of a convex polygon that is on or below a plane; fewer than three corners: no area.
/// @cite sutherland1974
std::vector<Vec3> clip_below(const std::vector<Vec3>& polygon, const Plane& plane);

}  // namespace clast
