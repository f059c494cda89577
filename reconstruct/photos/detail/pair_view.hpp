#pragma once
/// Projection of a compared pair of photos.
#include "reconstruct/photos/detail/rectified_pair.hpp"

namespace clast::photos_detail {

/// OpenCV disparities are in sixteenths of a pixel.
inline constexpr double kDisparityScale = 16.0;

/// Left camera of a rectified pair. A point p is projected to the pixel (u, v) with (u z, v z, z) =
/// matrix * (p - left). Its disparity is focal_baseline / z - offset.
struct PairProjection {
  Mat3 matrix;
  Vec3 left;
  double focal_baseline, offset;
  Vec3 direction;
  const DisparityMap* depths;

  explicit PairProjection(const DisparityMap& pair) : depths(&pair) {
    const Rectification& r = pair.view;
    Mat3 lens;
    lens << r.f, 0.0, r.cx, 0.0, r.f, r.cy, 0.0, 0.0, 1.0;
    matrix = lens * r.rotation;
    left = r.left;
    focal_baseline = r.f * r.baseline;
    offset = r.offset;
    direction = r.direction();
  }
};

}  // namespace clast::photos_detail
