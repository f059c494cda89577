#pragma once
/// Rigid transforms. Their names have the form destination_from_source and read from right to left.
#include "core/types.hpp"

namespace clast {

/// Rotation followed by a translation: `world_from_body * point_in_body` is in the world frame.
struct Pose {
  Vec3 translation = Vec3::Zero();
  Quat rotation = Quat::Identity();  ///< unit

  Vec3 operator*(const Vec3& point) const { return rotation * point + translation; }
  Pose operator*(const Pose& other) const {
    return {rotation * other.translation + translation, rotation * other.rotation};
  }
  Pose inverse() const {
    const Quat back = rotation.conjugate();
    return {-(back * translation), back};
  }
};

}  // namespace clast
