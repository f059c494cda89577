#pragma once
/// Vectors, matrices and quaternions of double precision and fixed size.
#include <Eigen/Core>
#include <Eigen/Geometry>

namespace clast {

using Vec2 = Eigen::Vector2d;
using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;
/// Unit quaternion. Its components are written in the order (w, x, y, z).
using Quat = Eigen::Quaterniond;

/// Returns the z component of the cross product of two plan vectors.
inline double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

inline constexpr double kPi = 3.14159265358979323846;

}  // namespace clast
