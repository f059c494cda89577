#pragma once
/// Planes and polygon clipping.
#include <vector>

#include "core/types.hpp"

namespace clast {

/// Plane n . p = d with unit normal n.
struct Plane {
  Vec3 normal = Vec3::UnitZ();
  double distance = 0.0;  ///< d, m

  double signed_distance(const Vec3& point) const { return normal.dot(point) - distance; }
};

/// Clips a convex polygon to the part on or below a plane. The result has fewer than three vertices
/// if this part is empty.
/// @cite sutherland1974
std::vector<Vec3> clip_polygon_below(const std::vector<Vec3>& polygon, const Plane& plane);

}  // namespace clast
