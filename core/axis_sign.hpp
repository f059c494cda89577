#pragma once
/// Which of its two directions an axis is given by.
#include "core/types.hpp"

namespace clast {

/// `axis`, or its opposite where the component that is largest in magnitude is negative.
inline Vec3 with_largest_component_positive(const Vec3& axis) {
  Eigen::Index largest = 0;
  axis.cwiseAbs().maxCoeff(&largest);
  return axis[largest] < 0.0 ? Vec3(-axis) : axis;
}

}  // namespace clast
