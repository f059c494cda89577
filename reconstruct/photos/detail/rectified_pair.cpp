#include "reconstruct/photos/detail/rectified_pair.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>

#include "reconstruct/photos/detail/photo_image.hpp"

namespace clast::photos_detail {

namespace {

constexpr int kBlock = 5;         ///< px, compared at a time
constexpr int kSmallStep = 8;     ///< penalty of a change of one pixel, per pixel compared
constexpr int kLargeStep = 32;    ///< of a larger one
constexpr int kUniqueness = 5;    ///< per cent by which the best match must be better
constexpr int kSpeckle = 150;     ///< px; smaller patches are dropped
constexpr int kSpeckleRange = 2;  ///< px
constexpr int kPrefilter = 31;
constexpr int kScale = 16;  ///< of OpenCV's shifts

/// Rectified photo; `inside` is 0 at pixels outside the photo.
struct Rectified {
  cv::Mat colour, grey, inside;
};

Rectified rectified(const PhotoModel& model, std::size_t photo, const Rectification& view,
                    double cx, const std::filesystem::path& mask_file) {
  const Photo& p = model.photos[photo];
  const cv::Mat image = read_colour_photo(p.file);
  const CameraIntrinsics lens = resized_intrinsics(model.lenses[p.lens], image.cols, image.rows);
  const Mat3 camera_from_view =
      p.camera_from_world.rotation.toRotationMatrix() * view.rotation.transpose();
  cv::Mat map_x(view.height, view.width, CV_32F), map_y(view.height, view.width, CV_32F);
  for (int v = 0; v < view.height; ++v) {
    for (int u = 0; u < view.width; ++u) {
      const Vec3 direction((u - cx) / view.f, (v - view.cy) / view.f, 1.0);
      const std::optional<Vec2> pixel = project(lens, camera_from_view * direction);
      const bool inside = pixel && pixel->x() >= 0.0 && pixel->y() >= 0.0 &&
                          pixel->x() <= lens.width - 1.0 && pixel->y() <= lens.height - 1.0;
      map_x.at<float>(v, u) = inside ? static_cast<float>(pixel->x()) : -1.0f;
      map_y.at<float>(v, u) = inside ? static_cast<float>(pixel->y()) : -1.0f;
    }
  }
  Rectified result;
  cv::remap(image, result.colour, map_x, map_y, cv::INTER_LINEAR);
  cv::cvtColor(result.colour, result.grey, cv::COLOR_BGR2GRAY);
  result.inside = map_x >= 0.0f;
  if (!mask_file.empty()) {
    const cv::Mat mask = read_grey_photo(mask_file);
    cv::Mat resampled_mask;
    cv::remap(mask, resampled_mask, map_x, map_y, cv::INTER_NEAREST);
    result.inside.setTo(0, resampled_mask < kMaskThreshold);
  }
  return result;
}

}  // namespace

Rectification rectify_pair(const PhotoModel& model, const StereoPair& pair,
                           const PhotoRegion& region, int max_image_side) {
  const Photo &a = model.photos[pair.first], &b = model.photos[pair.second];
  Rectification view;
  view.left = a.centre();
  view.right = b.centre();
  // The row axis runs from left to right; of the two ways the one that turns the photos least.
  Vec3 x = (view.right - view.left).normalized();
  const Vec3 photo_right = a.camera_from_world.rotation.conjugate() * Vec3::UnitX();
  if (x.dot(photo_right) < 0.0) {
    std::swap(view.left, view.right);
    x = -x;
  }
  const Vec3 ahead = region.centre - 0.5 * (view.left + view.right);
  const Vec3 z = (ahead - x * ahead.dot(x)).normalized();
  view.rotation << x.transpose(), z.cross(x).transpose(), z.transpose();
  view.baseline = (view.right - view.left).norm();
  const Vec3 middle = view.rotation * (region.centre - view.left);
  const double depth = middle.z();
  const double reach = std::min(region.radius, 0.8 * depth);
  const CameraIntrinsics &la = model.lenses[a.lens], &lb = model.lenses[b.lens];
  view.f = std::min({la.fx, la.fy, lb.fx, lb.fy});
  const double half_share = std::tan(std::asin(std::min(0.9, reach / depth)));
  view.f = std::min(view.f, 0.5 * max_image_side / half_share);
  view.offset = view.f * view.baseline / depth;
  const double nearest = view.f * view.baseline / (depth - reach) - view.offset;
  const double farthest = view.f * view.baseline / (depth + reach) - view.offset;
  view.min_disparity = static_cast<int>(std::floor(farthest)) - 1;
  view.disparity_count =
      16 * ((static_cast<int>(std::ceil(nearest)) + 1 - view.min_disparity + 15) / 16);
  // Matching finds nothing in the first `min_disparity + disparity_count` columns, and the last
  // `-min_disparity`.
  const int half = static_cast<int>(std::ceil(view.f * half_share)) + kBlock;
  const int before = std::max(0, view.min_disparity + view.disparity_count),
            after = std::max(0, -view.min_disparity);
  view.width = before + 2 * half + after;
  view.height = 2 * half;
  view.cx = before + half - view.f * middle.x() / depth;
  view.cy = half - view.f * middle.y() / depth;
  return view;
}

DisparityMap match_stereo_pair(const PhotoModel& model, const StereoPair& pair,
                               const PhotoRegion& region, int max_image_side,
                               const std::vector<std::filesystem::path>& masks) {
  DisparityMap result;
  result.view = rectify_pair(model, pair, region, max_image_side);
  const Rectification& view = result.view;
  const bool swapped = model.photos[pair.first].centre() != view.left;
  const std::size_t left = swapped ? pair.second : pair.first;
  const std::size_t right = swapped ? pair.first : pair.second;
  const auto mask_of = [&](std::size_t i) {
    return masks.empty() ? std::filesystem::path() : masks[i];
  };
  Rectified l = rectified(model, left, view, view.cx, mask_of(left));
  // Disparity d = f b / z - offset: the centre of the right camera is shifted by the offset.
  const Rectified r = rectified(model, right, view, view.cx + view.offset, mask_of(right));
  const auto matcher = cv::StereoSGBM::create(
      view.min_disparity, view.disparity_count, kBlock, kSmallStep * kBlock * kBlock,
      kLargeStep * kBlock * kBlock, 1, kPrefilter, kUniqueness, kSpeckle, kSpeckleRange,
      cv::StereoSGBM::MODE_SGBM_3WAY);
  matcher->compute(l.grey, r.grey, result.disparity);
  const int nothing = (view.min_disparity - 1) * kScale;
  for (int v = 0; v < view.height; ++v) {
    auto* row = result.disparity.ptr<short>(v);
    for (int u = 0; u < view.width; ++u) {
      const int other = u - static_cast<int>(std::lround(row[u] / static_cast<double>(kScale)));
      const bool known = row[u] > nothing && l.inside.at<unsigned char>(v, u) != 0 && other >= 0 &&
                         other < view.width && r.inside.at<unsigned char>(v, other) != 0;
      // Only what lies in the ball is the block's.
      if (!known ||
          (view.back_projected(u, v, row[u] / static_cast<double>(kScale)) - region.centre)
                  .squaredNorm() > region.radius * region.radius) {
        row[u] = kNoDisparity;
      }
    }
  }
  result.colour = std::move(l.colour);
  return result;
}

}  // namespace clast::photos_detail
