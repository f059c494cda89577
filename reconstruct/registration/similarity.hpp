#pragma once
/// Similarity transforms.
#include "core/pose.hpp"

namespace clast {

/// Scaling about the origin, then a rotation and a translation. Names have the form
/// destination_from_source, as those of poses.
struct Similarity {
  Pose pose = {};
  double scale = 1.0;  ///< positive

  Vec3 operator*(const Vec3& point) const { return pose * (scale * point); }
  Similarity operator*(const Similarity& other) const {
    return {{*this * other.pose.translation, (pose.rotation * other.pose.rotation).normalized()},
            scale * other.scale};
  }
  Similarity inverse() const {
    const Quat back = pose.rotation.conjugate();
    return {{-(back * pose.translation) / scale, back}, 1.0 / scale};
  }
};

}  // namespace clast
