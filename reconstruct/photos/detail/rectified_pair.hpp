#pragma once
/// Rectified stereo pairs and disparity maps.
#include <opencv2/core.hpp>

#include "reconstruct/photos/photo_region.hpp"
#include "reconstruct/photos/stereo_pairs.hpp"

namespace clast::photos_detail {

/// Rectified pair of pinhole cameras whose images cover the region.
///
/// A point p has the coordinates q = rotation * (p - left). Its pixel in the left image is u = f
/// q.x / q.z + cx, v = f q.y / q.z + cy. In the right image, it is (u - d, v) with the disparity d
/// = f b / q.z - offset.
struct Rectification {
  Mat3 rotation = Mat3::Identity();  ///< rectified from world
  Vec3 left = Vec3::Zero(), right = Vec3::Zero();
  double f = 0.0, cx = 0.0, cy = 0.0;          ///< px
  double baseline = 0.0;                       ///< distance b of the cameras, in units of the model
  double offset = 0.0;                         ///< px
  int width = 0, height = 0;                   ///< px
  int min_disparity = 0, disparity_count = 0;  ///< range of the disparity d, px

  Vec3 direction() const { return rotation.row(2); }  ///< viewing direction of both cameras
  /// Returns the point at a pixel of the left camera with disparity d.
  Vec3 back_projected(double u, double v, double d) const {
    const double z = f * baseline / (d + offset);
    return left + rotation.transpose() * Vec3((u - cx) * z / f, (v - cy) * z / f, z);
  }
};

/// Rectifies a pair of photos for stereo matching.
/// @param max_image_side  largest image side
Rectification rectify_pair(const PhotoModel& model, const StereoPair& pair,
                           const PhotoRegion& region, int max_image_side);

/// Disparities of a rectified pair of photos, and colours of the left photo.
struct DisparityMap {
  Rectification view;
  cv::Mat disparity;  ///< 16 d as CV_16S; `kNoDisparity` if unknown
  cv::Mat colour;     ///< CV_8UC3, blue first
};

inline constexpr short kNoDisparity = -32768;

/// Computes the disparities of a pair of photos by semi-global matching.
/// @param masks  one mask per photo, or empty; pixels with value 0 are not used
/// @cite hirschmueller2008
DisparityMap match_stereo_pair(const PhotoModel& model, const StereoPair& pair,
                               const PhotoRegion& region, int max_image_side,
                               const std::vector<std::filesystem::path>& masks);

}  // namespace clast::photos_detail
