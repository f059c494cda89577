#pragma once
/// Camera intrinsics and projection.
#include <array>
#include <optional>

#include "core/types.hpp"

namespace clast {

/// Central projection with lens distortion. It covers the models of COLMAP, Metashape and
/// AliceVision.
///
/// Camera frame: x right, y down, z forward. Pixels: x right, y down, with the centre of the first
/// pixel at (0, 0), as in OpenCV. Readers convert other conventions.
///
/// The pixel (u, v) of a point (x, y, z) follows from (a, b) = (x / z, y / z). For a fisheye, (a,
/// b) is scaled to the length atan |(a, b)|. With r^2 = a^2 + b^2 and g = (1 + k1 r^2 + k2 r^4 + k3
/// r^6 + k4 r^8) / (1 + d1 r^2 + d2 r^4 + d3 r^6),
///
/// a' = g a + 2 p1 a b + p2 (r^2 + 2 a^2),   u = fx a' + skew b' + cx b' = g b + p1 (r^2 + 2 b^2) +
/// 2 p2 a b,   v = fy b' + cy
/// @cite brown1966
struct CameraIntrinsics {
  int width = 0;  ///< px
  int height = 0;
  double fx = 0.0, fy = 0.0;               ///< focal length, px
  double cx = 0.0, cy = 0.0;               ///< principal point, px
  double skew = 0.0;                       ///< px
  std::array<double, 4> radial{};          ///< k1 to k4
  std::array<double, 3> radial_divisor{};  ///< d1 to d3
  double p1 = 0.0, p2 = 0.0;               ///< tangential distortion
  bool fisheye = false;

  /// Checks all values of the intrinsics.
  /// @throws InputError  if a value is impossible; names the value
  void check() const;
};

/// Projects a point in the camera frame to a pixel, which may be outside the photo. Empty if the
/// point is behind the camera or beyond the monotonic range of the distortion.
std::optional<Vec2> project(const CameraIntrinsics& lens, const Vec3& in_camera);

/// Returns the direction (x / z, y / z, 1) of a pixel, accurate to 1e-9 px. Empty if the distortion
/// cannot be inverted at the pixel.
std::optional<Vec3> unproject(const CameraIntrinsics& lens, const Vec2& pixel);

/// Returns the camera intrinsics of photos resized to `width` x `height`.
/// @throws InputError  if width and height are not scaled by a common factor, within a pixel
CameraIntrinsics resized_intrinsics(const CameraIntrinsics& lens, int width, int height);

}  // namespace clast
