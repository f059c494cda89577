#pragma once
/// Two photos turned so that a point lies in the same row of both, and the shift between them.
#include <opencv2/core.hpp>

#include "reconstruct/photos/photo_region.hpp"
#include "reconstruct/photos/stereo_pairs.hpp"

namespace clast::photos_detail {

/// Two pinhole cameras side by side, and how they see the ball of the region.
///
/// With q = turn * (p - left), a point p is seen in the left one at u = f q.x / q.z + cx,
/// v = f q.y / q.z + cy, and in the right one at u - d with d = f b / q.z - offset.
struct Rectification {
  Mat3 rotation = Mat3::Identity();  ///< rectified from world
  Vec3 left = Vec3::Zero(), right = Vec3::Zero();
  double f = 0.0, cx = 0.0, cy = 0.0;          ///< px
  double baseline = 0.0;                       ///< b, between the two
  double offset = 0.0;                         ///< px
  int width = 0, height = 0;                   ///< px
  int min_disparity = 0, disparity_count = 0;  ///< range of d, px

  Vec3 direction() const { return rotation.row(2); }  ///< in which both look
  /// The point seen at a pixel of the left one with shift d.
  Vec3 back_projected(double u, double v, double d) const {
    const double z = f * baseline / (d + offset);
    return left + rotation.transpose() * Vec3((u - cx) * z / f, (v - cy) * z / f, z);
  }
};

/// @param most_pixels  largest side
Rectification rectify_pair(const PhotoModel& model, const StereoPair& pair,
                           const PhotoRegion& region, int most_pixels);

/// Shifts of a pair, and the left photo's colours.
struct DisparityMap {
  Rectification view;
  cv::Mat disparity;  ///< 16 times d, CV_16S; `kNoDisparity` where it isn't known
  cv::Mat colour;     ///< CV_8UC3, blue first
};

inline constexpr short kNoDisparity = -32768;

/// Compares the photos by semi-global matching.
/// @param masks  per photo, empty or 0 where the photo is not to be used
/// @cite hirschmueller2008
DisparityMap match_stereo_pair(const PhotoModel& model, const StereoPair& pair,
                               const PhotoRegion& region, int most_pixels,
                               const std::vector<std::filesystem::path>& masks);

}  // namespace clast::photos_detail
