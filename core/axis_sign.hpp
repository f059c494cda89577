#pragma once
/// Canonical sign of an axis.
#include "core/types.hpp"

namespace clast {

/// Returns `axis` or its opposite, such that the component of largest magnitude is positive.
inline Vec3 with_largest_component_positive(const Vec3& axis) {
  Eigen::Index largest = 0;
  axis.cwiseAbs().maxCoeff(&largest);
  return axis[largest] < 0.0 ? Vec3(-axis) : axis;
}

}  // namespace clast
