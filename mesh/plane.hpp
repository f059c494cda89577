#pragma once
/// A plane in space.
#include "core/types.hpp"

namespace clast {

/// All p with n . p = d, with the unit normal n.
struct Plane {
  Vec3 normal = Vec3::UnitZ();
  double distance = 0.0;  ///< d, m

  double height(const Vec3& point) const { return normal.dot(point) - distance; }
};

}  // namespace clast
