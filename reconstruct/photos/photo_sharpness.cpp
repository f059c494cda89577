#include "reconstruct/photos/photo_sharpness.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "core/parallel.hpp"
#include "reconstruct/photos/detail/photo_image.hpp"

namespace clast {

namespace {

constexpr int kWidth = 1600;    ///< px; larger photos hold noise at the finest scale
constexpr double kSigma = 1.5;  ///< px, of the smoothing

/// Part of the photo about the block; all of it where the block isn't inside.
cv::Rect about_block(const PhotoModel& model, std::size_t i, const PhotoRegion& region,
                     const cv::Mat& image) {
  const cv::Rect all(0, 0, image.cols, image.rows);
  const std::optional<Vec2> seen = seen_at(model, i, region.centre);
  if (!seen) return all;
  const Lens& lens = model.lenses[model.photos[i].lens];
  const double factor = static_cast<double>(image.cols) / lens.width;
  const double depth = (model.photos[i].camera_from_world * region.centre).z();
  const int half = static_cast<int>(0.6 * factor * lens.fx * region.radius / depth);
  const cv::Rect part(static_cast<int>(seen->x() * factor) - half,
                      static_cast<int>(seen->y() * factor) - half, 2 * half, 2 * half);
  const cv::Rect inside = part & all;
  return inside.area() > 1000 ? inside : all;
}

double energy(const cv::Mat& image) {
  cv::Mat dx, dy;
  cv::Sobel(image, dx, CV_32F, 1, 0);
  cv::Sobel(image, dy, CV_32F, 0, 1);
  return dx.dot(dx) + dy.dot(dy);
}

}  // namespace

std::vector<Sharpness> sharpness_of(const PhotoModel& model, const PhotoRegion& region,
                                    unsigned threads) {
  const detail::SingleThreaded guard;
  std::vector<double> lost(model.photos.size());
  parallel_for(model.photos.size(), threads, [&](std::size_t i) {
    cv::Mat grey = detail::read_grey_photo(model.photos[i].file);
    grey = grey(about_block(model, i, region, grey)).clone();
    if (grey.cols > kWidth) {
      cv::resize(grey, grey, {}, static_cast<double>(kWidth) / grey.cols,
                 static_cast<double>(kWidth) / grey.cols, cv::INTER_AREA);
    }
    cv::Mat smooth;
    cv::GaussianBlur(grey, smooth, {}, kSigma);
    const double fine = energy(grey);
    lost[i] = fine > 0.0 ? 1.0 - energy(smooth) / fine : 0.0;
    // As a ratio of energies lost and kept, which falls with the square of the blur.
    lost[i] = lost[i] / std::max(1e-9, 1.0 - lost[i]);
  });
  std::vector<double> sorted = lost;
  std::sort(sorted.begin(), sorted.end());
  const double middle = sorted.empty() ? 0.0 : sorted[sorted.size() / 2];
  std::vector<Sharpness> result;
  for (const double value : lost) {
    const double relative = middle > 0.0 ? value / middle : 1.0;
    result.push_back({relative, relative < kBlurred});
  }
  return result;
}

}  // namespace clast
