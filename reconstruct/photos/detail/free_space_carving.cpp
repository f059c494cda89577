#include "reconstruct/photos/detail/free_space_carving.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "core/parallel.hpp"

namespace clast::photos_detail {

namespace {

constexpr std::size_t kAcross = 128;     ///< cubes along the diameter of the region
constexpr double kFrontMargin = 3.0;     ///< times the tolerance, by which a cube must lie in front
constexpr double kAgreedFraction = 0.5;  ///< of the picture of a cube
constexpr int kMinViews = 2;             ///< that look through a cube
constexpr short kBlocked = 32767;
/// Half the diagonal of a cube of side 1.
const double kHalfDiagonal = 0.5 * std::sqrt(3.0);

/// Disparity of the nearest surface within `reach` of each pixel; `kBlocked` if few pixels agree.
cv::Mat nearest_shifts(const cv::Mat& disparity, const cv::Mat& agreed, int reach) {
  const cv::Size window(2 * reach + 1, 2 * reach + 1);
  cv::Mat nearest, fraction;
  cv::dilate(disparity, nearest, cv::getStructuringElement(cv::MORPH_RECT, window));
  cv::boxFilter(agreed, fraction, CV_32F, window, {-1, -1}, true, cv::BORDER_CONSTANT);
  nearest.setTo(kBlocked, fraction < kAgreedFraction);
  return nearest;
}

}  // namespace

FreeSpaceGrid carve_free_space(const std::vector<PairProjection>& views,
                               const std::vector<cv::Mat>& agreed, const PhotoRegion& region,
                               double tolerance, unsigned threads) {
  FreeSpaceGrid result;
  result.side = 2.0 * region.radius / static_cast<double>(kAcross);
  result.origin = region.centre - Vec3::Constant(region.radius);
  result.counts = {kAcross, kAcross, kAcross};
  const double half = kHalfDiagonal * result.side;
  std::vector<cv::Mat> nearest(views.size());
  parallel_for(views.size(), threads, [&](std::size_t i) {
    const double depth = (region.centre - views[i].left).norm();
    const int reach = static_cast<int>(std::ceil(views[i].depths->view.f * half / depth));
    nearest[i] = nearest_shifts(views[i].depths->disparity, agreed[i], reach);
  });
  const std::size_t layer = kAcross * kAcross;
  result.is_free_cell.assign(kAcross * layer, 0);
  parallel_for(kAcross, threads, [&](std::size_t z) {
    for (std::size_t cube = z * layer; cube < (z + 1) * layer; ++cube) {
      const Vec3 position = result.cell_centre(cube);
      if ((position - region.centre).norm() > region.radius) continue;
      int pairs_through = 0;
      for (std::size_t i = 0; i < views.size() && pairs_through < kMinViews; ++i) {
        const Vec3 q = views[i].matrix * (position - views[i].left);
        if (!(q.z() > half)) continue;
        const int x = static_cast<int>(std::lround(q.x() / q.z()));
        const int y = static_cast<int>(std::lround(q.y() / q.z()));
        const cv::Mat& known = nearest[i];
        if (x < 0 || y < 0 || x >= known.cols || y >= known.rows) continue;
        // The far end of the cube would be seen at this shift, or a larger one.
        const double least = views[i].focal_baseline / (q.z() + half) - views[i].offset;
        pairs_through +=
            known.at<short>(y, x) / kDisparityScale < least - kFrontMargin * tolerance ? 1 : 0;
      }
      result.is_free_cell[cube] = pairs_through >= kMinViews ? 1 : 0;
    }
  });
  return result;
}

}  // namespace clast::photos_detail
