#pragma once
/// Vectors, matrices and quaternions used throughout: double precision, fixed size.
#include <Eigen/Core>
#include <Eigen/Geometry>

namespace clast {

using Vec2 = Eigen::Vector2d;
using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;
/// Unit quaternion. Built and written as (w, x, y, z).
using Quat = Eigen::Quaterniond;

inline constexpr double kPi = 3.14159265358979323846;

}  // namespace clast
