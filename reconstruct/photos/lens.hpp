#pragma once
/// How a camera turns directions into pixels.
#include <array>
#include <optional>

#include "core/types.hpp"

namespace clast {

/// A central projection with distortion, wide enough to hold the lens models of COLMAP, Metashape
/// and AliceVision.
///
/// Frame of the camera: x to the right of the photo, y down, z forward. Pixels: x to the right, y
/// down, and the centre of the first pixel is (0, 0), as in OpenCV; programs that put it at
/// (0.5, 0.5) are converted where their files are read.
///
/// (a, b) = (x / z, y / z), for a fisheye shortened to the length atan |(a, b)|; with
/// r^2 = a^2 + b^2 and g = (1 + k1 r^2 + k2 r^4 + k3 r^6 + k4 r^8) / (1 + d1 r^2 + d2 r^4 + d3 r^6)
///
///     a' = g a + 2 p1 a b + p2 (r^2 + 2 a^2),   u = fx a' + skew b' + cx
///     b' = g b + p1 (r^2 + 2 b^2) + 2 p2 a b,   v = fy b' + cy
/// @cite brown1966
struct CameraIntrinsics {
  int width = 0;  ///< px
  int height = 0;
  double fx = 0.0, fy = 0.0;        ///< focal length, px
  double cx = 0.0, cy = 0.0;        ///< principal point, px
  double skew = 0.0;                ///< px
  std::array<double, 4> radial{};   ///< k1 to k4
  std::array<double, 3> divisor{};  ///< d1 to d3
  double p1 = 0.0, p2 = 0.0;        ///< tangential
  bool fisheye = false;

  /// @throws InputError  a value that no lens has, named
  void check() const;
};

/// Where a point in the camera's frame is seen; it may be outside the photo. None: it lies behind
/// the camera, or so far to the side that the distortion turns back.
std::optional<Vec2> project(const CameraIntrinsics& lens, const Vec3& in_camera);

/// The direction (x / z, y / z, 1) that is seen at a pixel, to 1e-9 px. None: the distortion has no
/// inverse there.
std::optional<Vec3> unproject(const CameraIntrinsics& lens, const Vec2& pixel);

/// The same lens for photos that were made smaller or larger.
/// @throws InputError  the sides don't change by one factor (within a pixel)
CameraIntrinsics resized(const CameraIntrinsics& lens, int width, int height);

}  // namespace clast
